#include "agents/coordinator/pursue/goal_in_hand.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "agents/coordinator/pursue/goal_state.hpp"
#include "agents/coordinator/retried_commit.hpp"

namespace pizarra::coordinator {

namespace {

constexpr Duration untold_pause = 1s;

bool is_in_hand(const Datum& state) { return state.is_symbol("running") || state.is_symbol("kept"); }

}  // namespace

Task<void> GoalInHand::resume() {
  const Datum any = "?"_sym;
  const std::vector<Fact> goals = co_await facts_now(context_.board, context_.executor, list("goal"_sym, any, any));
  std::vector<Fact> states =
      co_await facts_now(context_.board, context_.executor, list("goal-state"_sym, any, any, any));
  std::erase_if(states, [](const Fact& state) { return !is_in_hand(state.datum[2]); });
  std::optional<Goal> goal;
  for (const Fact& fact : goals) {
    const std::int64_t number = fact.datum[1].integer();
    last_number_ = std::max(last_number_, number);
    const auto state = std::ranges::find_if(states, [&](const Fact& told) { return told.datum[1] == fact.datum[1]; });
    if (state == states.end()) continue;
    const auto wanted = fact.datum[2].items();
    goal = Goal{number, {wanted.begin(), wanted.end()}, stage_told(state->datum[3])};
  }
  if (!goal) co_return;
  current_ = goal;
  const std::string sentence = fmt::format("going on with goal {} after a restart", goal->number);
  co_await story_.tell("agent", sentence, to_datum(goal->number));
}

Task<Result<std::int64_t>> GoalInHand::submit(std::vector<Datum> facts) {
  const Turns::Turn turn = co_await turns_.take();
  const Goal goal{last_number_ + 1, std::move(facts)};
  const Datum told_goal = list("goal"_sym, goal.number, Datum::list(goal.facts));
  Transaction transaction;
  if (current_) transaction.tell(list("goal-state"_sym, current_->number, "replaced"_sym, Datum()));
  transaction.tell(told_goal);
  transaction.tell(list("goal-state"_sym, goal.number, "running"_sym, Datum()));
  story_.add(transaction, "goal", goal_sentence(told_goal), told_goal[2]);
  const Result<Revision> told = co_await commit(context_.board, context_.executor, std::move(transaction));
  if (!told) co_return fail(told);
  last_number_ = goal.number;
  current_ = goal;
  interruption_.raise();
  wanted_.wake_all();
  co_return goal.number;
}

Task<Result<void>> GoalInHand::cancel() {
  const Turns::Turn turn = co_await turns_.take();
  if (!current_) co_return fail("no-goal", "there is no goal in hand");
  const Result<Revision> told = co_await tell_outcome(current_->number, "cancelled", Datum());
  if (!told) co_return fail(told);
  current_.reset();
  interruption_.raise();
  co_return Result<void>();
}

Task<Goal> GoalInHand::next() {
  while (!current_) co_await wanted_.wait();
  co_return *current_;
}

Task<void> GoalInHand::tell_progress(std::int64_t goal, std::string_view state, Datum detail, std::string_view kind,
                                     std::string sentence) {
  const Turns::Turn turn = co_await turns_.take();
  if (!is_wanted(goal)) co_return;
  Transaction transaction;
  transaction.tell(list("goal-state"_sym, goal, Datum::symbol(state), detail));
  story_.add(transaction, kind, sentence, detail);
  co_await commit(context_.board, context_.executor, std::move(transaction));
}

Task<void> GoalInHand::finish(Goal goal, Result<void> outcome) {
  bool ended = co_await end(goal, outcome);
  while (!ended) {
    co_await sleep(context_.executor, untold_pause);
    ended = co_await end(goal, outcome);
  }
}

Task<bool> GoalInHand::end(Goal goal, Result<void> outcome) {
  const Turns::Turn turn = co_await turns_.take();
  if (!is_wanted(goal.number)) co_return true;
  const std::string_view state = outcome ? "reached" : "refused";
  const Datum detail = outcome ? Datum() : failure_to_datum(outcome.error());
  const Result<Revision> told = co_await tell_outcome(goal.number, state, detail);
  const bool try_again = !told && told.error().symbol == "journal-full";
  if (try_again) co_return false;
  current_.reset();
  co_return true;
}

Task<Result<Revision>> GoalInHand::tell_outcome(std::int64_t number, std::string_view state, Datum detail) {
  const Datum told = list("goal-state"_sym, number, Datum::symbol(state), detail);
  Transaction transaction;
  transaction.tell(told);
  story_.add(transaction, "result", outcome_sentence(told), detail);
  return commit(context_.board, context_.executor, std::move(transaction));
}

}  // namespace pizarra::coordinator
