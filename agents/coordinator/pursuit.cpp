#include "agents/coordinator/pursuit.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <iterator>
#include <map>

#include "agents/coordinator/telling.hpp"
#include "lisp/writer.hpp"

namespace pizarra {

namespace {

// Bounds of one goal. A tower of four takes about ten operations; every disturbance costs a few more.
constexpr int most_rounds = 150;
constexpr int most_plans = 30;
constexpr int most_failures = 25;
constexpr int most_failures_of_one = 5;
// Collisions of one operation till what it is about is pushed: trying the same again would end the same way.
constexpr int failures_till_loosened = 2;

std::vector<Datum> missing_from(const Facts& beliefs, const Facts& needed) {
  std::vector<Datum> missing;
  std::ranges::set_difference(needed, beliefs, std::back_inserter(missing));
  return missing;
}

// What ends the pursuit whatever else might be tried.
bool is_final(const Failure& failure) { return failure.symbol == "interrupted" || failure.symbol == "absent"; }

}  // namespace

Task<void> Pursuit::run() {
  co_await resume();
  while (true) {
    while (!current_) co_await wanted_.wait();
    const Goal goal = *current_;
    vigil_.clear_interrupt();
    if (planned_for_ != goal.number) table_.reset();
    const Result<void> outcome = co_await pursue(goal);
    const bool still_wanted = current_ && current_->number == goal.number;
    if (!still_wanted) continue;
    current_.reset();
    co_await finish(goal, outcome);
  }
}

Task<Result<void>> Pursuit::pursue(Goal goal) {
  const Result<void> tracking = co_await eyes_.track();
  if (!tracking) co_return tracking;
  const Result<void> looked = co_await eyes_.fresh_look();
  if (!looked) co_return looked;
  const std::vector<std::string> objects = objects_of(goal);
  const Result<void> there = co_await look_for(objects);
  if (!there) co_return there;
  co_await await_steady(objects);
  const Result<void> outcome = co_await rounds(goal);
  co_return outcome;
}

Task<Result<void>> Pursuit::rounds(Goal goal) {
  const std::vector<std::string> objects = objects_of(goal);
  std::map<Datum, int> failures_of;
  int failures = 0;
  int plans = 0;
  std::optional<std::size_t> expected;
  for (int round = 0; round < most_rounds; ++round) {
    if (vigil_.interrupted()) co_return fail("interrupted", "another goal, or none, is wanted now");
    // The arm keeps out of the way of a hand at work.
    const bool calm = surroundings_.calm();
    if (!calm) co_await await_steady(objects);
    std::optional<std::size_t> next;
    if (table_) next = table_->furthest(surroundings_.beliefs());
    if (!next) {
      if (table_ && expected) {
        const std::vector<Datum> lost = missing_from(surroundings_.beliefs(), table_->needed(*expected));
        co_await tell_difference(lost, "the rest of the plan");
      }
      expected.reset();
      if (++plans > most_plans) co_return fail("gave-up", "too many plans came to nothing");
      const Result<void> planned = co_await plan_anew(goal, objects);
      if (!planned) co_return planned;
      continue;
    }
    const std::size_t foreseen = expected.value_or(*next);
    if (*next != foreseen) co_await tell_unexpected(foreseen, *next);
    expected = next;
    if (*next == table_->plan().size()) {
      const bool settled = co_await settles(goal);
      if (settled) co_return Result<void>();
      expected.reset();
      continue;
    }
    const Datum operation = table_->plan()[*next].name;
    const Result<void> done = co_await do_operation(*next);
    if (done) {
      expected = *next + 1;
      failures_of.erase(operation);
      continue;
    }
    if (is_final(done.error())) co_return done;
    // A difference was told when it was noticed; what follows from it is not another one.
    expected.reset();
    if (done.error().symbol != "difference") {
      const bool too_often = ++failures > most_failures || ++failures_of[operation] > most_failures_of_one;
      if (too_often) co_return done;
      const bool jammed = done.error().symbol == "stopped" && failures_of[operation] % failures_till_loosened == 0;
      if (jammed) co_await loosen(operation);
    }
    co_await await_steady(objects);
  }
  co_return fail("gave-up", "the goal was not reached in a great many operations");
}

Task<Result<void>> Pursuit::do_operation(std::size_t index) {
  // Step h: the planner hands out one operation at a time. The coordinator keeps the plan too, since only it knows
  // which operation can be next, and a planner that was restarted has forgotten.
  const std::optional<Datum> handed_out = co_await planning_.operation(index);
  const GroundOperation operation = table_->plan()[index];
  if (handed_out && *handed_out != operation.name) {
    table_.reset();
    co_return fail("difference", "somebody else had the planner make another plan", *handed_out);
  }
  vigil_.begin(*table_, index);
  const Result<void> done = co_await runner_.run(index, operation);
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
  const Facts wanted(goal.facts.begin(), goal.facts.end());
  const Time settled = context_.executor.now() + options_.settle;
  while (context_.executor.now() < settled) {
    const Result<void> looked = co_await eyes_.fresh_look();
    if (!looked) co_return false;
    if (vigil_.interrupted()) co_return false;
    const std::vector<Datum> lost = missing_from(surroundings_.beliefs(), wanted);
    if (lost.empty()) continue;
    co_await tell_difference(lost, "the goal");
    co_await await_steady(objects_of(goal));
    co_return false;
  }
  co_return true;
}

Task<Result<std::int64_t>> Pursuit::submit(std::vector<Datum> facts) {
  const Goal goal{++last_number_, std::move(facts)};
  Transaction transaction;
  if (current_) transaction.tell(list("goal-state"_sym, current_->number, "replaced"_sym, Datum()));
  transaction.tell(list("goal"_sym, goal.number, Datum::list(goal.facts)));
  transaction.tell(list("goal-state"_sym, goal.number, "running"_sym, Datum()));
  current_ = goal;
  vigil_.interrupt();
  const Result<Revision> told = co_await commit(context_.board, context_.executor, std::move(transaction));
  if (!told) co_return fail(told);
  std::string sentence = fmt::format("goal {}:", goal.number);
  for (const Datum& fact : goal.facts) sentence += ' ' + write(fact);
  co_await story_.tell("goal", sentence, Datum::list(goal.facts));
  wanted_.wake_all();
  co_return goal.number;
}

Task<bool> Pursuit::cancel() {
  if (!current_) co_return false;
  const Datum state = list("goal-state"_sym, current_->number, "cancelled"_sym, Datum());
  const std::string sentence = fmt::format("goal {} is cancelled", current_->number);
  current_.reset();
  vigil_.interrupt();
  Transaction transaction;
  transaction.tell(state);
  co_await commit(context_.board, context_.executor, std::move(transaction));
  co_await story_.tell("result", sentence, state);
  co_return true;
}

}  // namespace pizarra
