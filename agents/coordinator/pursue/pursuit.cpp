#include "agents/coordinator/pursue/pursuit.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <iterator>

#include "agents/coordinator/retried_commit.hpp"
#include "lisp/forms/goal_formula.hpp"
#include "lisp/writer.hpp"

namespace pizarra::coordinator {

namespace {

// Bounds of one goal. A tower of four takes about ten operations; every disturbance costs a few more.
constexpr int most_rounds = 150;
constexpr int most_plans = 30;
constexpr int most_failures = 25;
constexpr int most_failures_of_one = 5;
// Failures of one operation till something else is tried.
constexpr int failures_till_otherwise = 2;
// Verdicts of one attempt after another that may come of a camera that was moved.
constexpr int most_doubts = 3;
constexpr Duration untold_pause = 1s;

// The operation that follows this one, unless something differs. What must hold after that is not known yet.
NextOperation once_done(const NextOperation& done) {
  return {done.index + 1, {done.rest.begin() + 1, done.rest.end()}, done.needed_after, {}};
}

// What ends the pursuit whatever else might be tried.
bool is_final(const Failure& failure) { return failure.symbol == "interrupted" || failure.symbol == "absent"; }

bool is_of_how_it_lies(const Failure& failure) {
  constexpr std::string_view symbols[] = {"stopped", "missed", "no-convergence", "no-effect"};
  return std::ranges::find(symbols, failure.symbol) != std::end(symbols);
}

}  // namespace

Task<void> Pursuit::run() {
  while (true) {
    while (!current_) co_await wanted_.wait();
    const Goal goal = *current_;
    vigil_.clear_interrupt();
    const Result<void> outcome = co_await pursue(goal);
    co_await finish(goal, outcome);
  }
}

Task<Result<void>> Pursuit::pursue_once(Goal goal) {
  hold_up_.went_on();
  set_aside_ = 0;
  hid_.clear();
  int doubts = 0;
  while (true) {
    const Result<void> outcome = co_await attempt(goal);
    // What ended it may not be so.
    const bool in_doubt = !outcome && !is_final(outcome.error()) && surroundings_.scene().camera().doubtful();
    if (in_doubt && ++doubts <= most_doubts) continue;
    const bool held_up = !outcome && is_hold_up(outcome.error());
    if (!held_up) co_return outcome;
    const Result<void> over = co_await hold_up_.await_end(outcome.error());
    if (!over) co_return over;
  }
}

Task<Result<void>> Pursuit::attempt(Goal goal) {
  const Result<void> tracking = co_await eyes_.track();
  if (!tracking) co_return tracking;
  const Result<void> looked = co_await eyes_.fresh_look();
  if (!looked) co_return looked;
  const Result<void> found = co_await find_camera();
  if (!found) co_return found;
  const std::vector<std::string> objects = objects_of(goal);
  const Result<void> there = co_await look_for(objects);
  if (!there) co_return there;
  co_await await_steady(objects);
  if (options_.open_loop) {
    const Result<void> carried_out = co_await carry_out_blindly(goal);
    co_return carried_out;
  }
  const Result<void> outcome = co_await rounds(goal);
  co_return outcome;
}

Task<Result<void>> Pursuit::find_camera() {
  while (!surroundings_.scene().camera().known()) {
    vigil_.rest();
    const Result<void> found = co_await survey_.run();
    // A motion that ended early says nothing of the camera.
    const bool ended_early = !found && found.error().symbol == "stopped";
    if (!ended_early) co_return found;
    const Result<void> over = co_await hold_up_.await_end(found.error());
    if (!over) co_return over;
  }
  co_return Result<void>();
}

Task<Result<void>> Pursuit::carry_out_blindly(Goal goal) {
  const Result<bool> planned = co_await plan_anew(goal, objects_of(goal));
  if (!planned) co_return fail(planned);
  const Result<std::optional<NextOperation>> plan = co_await hand_out(goal.number);
  if (!plan) co_return fail(plan);
  if (!*plan) co_return fail("off-plan", "the first plan did not serve to begin with");
  const NextOperation first = **plan;
  vigil_.rest();
  for (std::size_t i = 0; i < first.rest.size(); ++i) {
    if (vigil_.interrupted()) co_return fail("interrupted", "another goal, or none, is wanted now");
    co_await runner_.run(first.index + i, first.rest[i]);
  }
  co_return Result<void>();
}

Task<Result<void>> Pursuit::rounds(Goal goal) {
  const std::vector<std::string> objects = objects_of(goal);
  Progress progress;
  for (int round = 0; round < most_rounds; ++round) {
    if (vigil_.interrupted()) co_return fail("interrupted", "another goal, or none, is wanted now");
    const Result<void> found = co_await find_camera();
    if (!found) co_return found;
    // The arm keeps out of the way of a hand at work.
    const bool calm = surroundings_.scene().calm();
    if (!calm) co_await await_steady(objects);
    const Result<std::optional<NextOperation>> chosen = co_await choose(goal, progress);
    if (!chosen) co_return fail(chosen);
    if (!*chosen) continue;
    const NextOperation& next = **chosen;
    if (next.rest.empty()) {
      const bool settled = co_await settles(goal);
      if (settled) co_return Result<void>();
      progress.expected.reset();
      progress.announced.reset();
      continue;
    }
    const Result<void> done = co_await do_operation(next);
    if (done) {
      hold_up_.went_on();
      progress.expected = once_done(next);
      progress.announced = next.index + 1;
      progress.failures_of.erase(next.rest.front().name);
      continue;
    }
    const Result<void> recovered = co_await recover(next.rest.front(), done.error(), progress);
    if (!recovered) co_return recovered;
    co_await await_steady(objects);
  }
  co_return fail("gave-up", "the goal was not reached in a great many operations");
}

Task<Result<std::optional<NextOperation>>> Pursuit::hand_out(std::int64_t goal) {
  if (planned_for_ != goal) co_return std::nullopt;
  Result<NextOperation> next = co_await planning_.next(goal);
  if (next) co_return std::move(*next);
  const std::string& why = next.error().symbol;
  if (why == "off-plan" || why == "not-ready") co_return std::nullopt;
  co_return fail(next);
}

Task<Result<std::optional<NextOperation>>> Pursuit::choose(Goal goal, Progress& progress) {
  const Result<std::optional<NextOperation>> next = co_await hand_out(goal.number);
  if (!next) co_return next;
  if (!*next) {
    if (progress.expected) {
      const std::vector<Datum> lost = missing_from(surroundings_.beliefs(), progress.expected->needed);
      co_await tell_difference(lost, "the rest of the plan");
    }
    progress.expected.reset();
    progress.announced.reset();
    if (++progress.plans > most_plans) co_return fail("gave-up", "too many plans came to nothing");
    std::vector<std::string> objects = objects_of(goal);
    const Result<bool> planned = co_await plan_anew(goal, std::move(objects));
    if (!planned) co_return fail(planned);
    if (*planned) progress.announced = 0;
    co_return next;
  }
  const std::size_t index = (*next)->index;
  const bool unexpected = progress.expected && index != progress.expected->index;
  if (unexpected) co_await tell_unexpected(*progress.expected, index);
  if (progress.announced != index) co_await tell_still_serves(goal.number, **next);
  progress.expected = *next;
  progress.announced = index;
  co_return next;
}

Task<Result<void>> Pursuit::recover(GroundOperation operation, Failure why, Progress& progress) {
  const bool ends = is_final(why) || is_hold_up(why);
  if (ends) co_return fail(why);
  // A difference was told when it was noticed; what follows from it is not another one.
  progress.expected.reset();
  if (why.symbol == "difference" || why.symbol == "camera-doubtful") {
    progress.announced.reset();
    co_return Result<void>();
  }
  const int failures = ++progress.failures_of[operation.name];
  const bool too_often = ++progress.failures > most_failures || failures > most_failures_of_one;
  if (too_often) co_return fail(why);
  const bool in_vain = failures % failures_till_otherwise == 0;
  if (in_vain) co_await try_otherwise(operation, std::move(why));
  co_return Result<void>();
}

// Whatever comes of it is seen afterwards.
Task<void> Pursuit::try_otherwise(GroundOperation operation, Failure why) {
  const bool hidden = why.symbol == "lost-sight" && why.subject.is_symbol();
  if (hidden) {
    const std::string missing(why.subject.text());
    SetAside none;
    co_await clear_view(missing, none);
    co_return;
  }
  const bool lies_badly = is_of_how_it_lies(why);
  if (lies_badly) co_await rescues_.loosen(operation.name);
}

Task<Result<void>> Pursuit::do_operation(NextOperation next) {
  const GroundOperation& operation = next.rest.front();
  vigil_.begin(operation, next.needed_after);
  const Result<void> done = co_await runner_.run(next.index, operation);
  if (done) co_return done;
  const Failure& why = done.error();
  if (why.symbol == "interrupted") co_return done;
  if (why.symbol == "difference") {
    std::vector<Datum> lost(why.subject.items().begin(), why.subject.items().end());
    co_await tell_difference(std::move(lost), write(operation.name));
  } else {
    const std::string sentence = fmt::format("{} failed: {}", write(operation.name), why.sentence);
    co_await story_.tell("operation", sentence, failure_to_datum(why));
  }
  co_return done;
}

Task<bool> Pursuit::settles(Goal goal) {
  const Time settled = context_.executor.now() + options_.settle;
  while (context_.executor.now() < settled) {
    const Result<void> looked = co_await eyes_.fresh_look();
    if (!looked) co_return false;
    if (vigil_.interrupted()) co_return false;
    const std::vector<Datum> lost = forms::unmet_parts(goal.facts, surroundings_.beliefs(), planning_.objects());
    if (lost.empty()) continue;
    co_await tell_difference(lost, "the goal");
    co_await await_steady(objects_of(goal));
    co_return false;
  }
  co_return true;
}

Task<Result<std::int64_t>> Pursuit::submit(std::vector<Datum> facts) {
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
  vigil_.interrupt();
  wanted_.wake_all();
  co_return goal.number;
}

Task<Result<void>> Pursuit::cancel() {
  const Turns::Turn turn = co_await turns_.take();
  if (!current_) co_return fail("no-goal", "there is no goal in hand");
  const Result<Revision> told = co_await tell_outcome(current_->number, "cancelled", Datum());
  if (!told) co_return fail(told);
  current_.reset();
  vigil_.interrupt();
  co_return Result<void>();
}

// A goal stays in hand until its end could be told.
Task<void> Pursuit::finish(Goal goal, Result<void> outcome) {
  bool ended = co_await end(goal, outcome);
  while (!ended) {
    co_await sleep(context_.executor, untold_pause);
    ended = co_await end(goal, outcome);
  }
}

Task<bool> Pursuit::end(Goal goal, Result<void> outcome) {
  const Turns::Turn turn = co_await turns_.take();
  const bool still_wanted = current_ && current_->number == goal.number;
  if (!still_wanted) co_return true;
  const std::string_view state = outcome ? "reached" : "refused";
  const Datum detail = outcome ? Datum() : failure_to_datum(outcome.error());
  const Result<Revision> told = co_await tell_outcome(goal.number, state, detail);
  const bool try_again = !told && told.error().symbol == "journal-full";
  if (try_again) co_return false;
  current_.reset();
  co_return true;
}

Task<Result<Revision>> Pursuit::tell_outcome(std::int64_t number, std::string_view state, Datum detail) {
  const Datum told = list("goal-state"_sym, number, Datum::symbol(state), detail);
  Transaction transaction;
  transaction.tell(told);
  story_.add(transaction, "result", outcome_sentence(told), detail);
  return commit(context_.board, context_.executor, std::move(transaction));
}

}  // namespace pizarra::coordinator
