#include <algorithm>
#include <fmt/format.h>

#include "agents/coordinator/perceive/missing_objects.hpp"
#include "agents/coordinator/pursue/pursuit.hpp"
#include "agents/coordinator/retried_commit.hpp"
#include "lisp/forms/goal_formula.hpp"
#include "lisp/writer.hpp"

namespace pizarra::coordinator {

namespace {

constexpr Duration steady_patience = 8s;
constexpr Duration second_proof_after = 2s;
constexpr Duration planner_pause = 1s;
constexpr int planner_tries = 3;
constexpr int most_attempts = 12;
// How many things are set aside in search of one, and how long each time one looks what was behind.
constexpr std::size_t most_set_aside = 6;
constexpr int most_set_aside_of_goal = 10;  // what is found may be hidden again, and again
constexpr int tries_to_set_aside = 3;       // a try that failed may have moved it to where it can be grasped
constexpr Duration look_behind = 1500ms;

bool is_in_hand(const Datum& state) { return state.is_symbol("running") || state.is_symbol("kept"); }

// As tell_progress() told it: (stage K) of the stage that is pursued, from 1.
std::size_t stage_of(const std::vector<Fact>& states, std::int64_t number) {
  for (const Fact& state : states) {
    const Datum& detail = state.datum[3];
    const bool told = state.datum[1].integer() == number && detail.is_form("stage") && detail.size() == 2;
    if (told && detail[1].is_integer() && detail[1].integer() > 0)
      return static_cast<std::size_t>(detail[1].integer() - 1);
  }
  return 0;
}

// A rescue that fails otherwise has been tried.
bool ends_search(const Failure& failure) { return failure.symbol == "interrupted" || is_hold_up(failure); }

bool is_verdict(const Failure& failure) {
  return failure.symbol == "no-plan" || failure.symbol == "gave-up" || failure.symbol == "absent";
}

}  // namespace

// Steps b and c: each object is found, whatever was seen of it lately, and all that are missing are named.
Task<Result<void>> Pursuit::look_for(std::vector<std::string> objects) {
  std::vector<std::string> missing;
  for (const std::string& name : objects) {
    const Time deadline = context_.executor.now() + options_.missing_patience;
    const Result<void> there = co_await look_once_for(name, deadline);
    const bool unseen = !there && there.error().symbol == "missing-object";
    if (!there && !unseen) co_return there;
    if (unseen) missing.push_back(name);
  }
  if (missing.empty()) co_return Result<void>();
  const Failure why = missing_objects(missing);
  co_return fail(why);
}

bool Pursuit::stands_low() const {
  const std::optional<Eigen::Vector3d> grip = surroundings_.scene().grip_mm();
  return grip && grip->z() < options_.travel_height_mm - 10;
}

// Where it does not show by itself, what may hide it is set aside, one thing after another.
Task<Result<void>> Pursuit::look_once_for(std::string object, Time deadline) {
  bool out_of_the_way = false;
  SetAside set_aside;
  bool looked_behind = false;
  Time doubtful = context_.executor.now() + options_.missing_patience / 2;
  while (true) {
    if (vigil_.interrupted()) co_return fail("interrupted", "another goal, or none, is wanted now");
    const Result<bool> found = co_await eyes_.find(object);
    if (!found) co_return fail(found);
    if (surroundings_.scene().sightings().remembered(object, options_.grace_looks)) co_return Result<void>();
    // Eyes that restarted find it, and may not track it any more.
    Result<void> tracking;
    if (*found) tracking = co_await eyes_.track();
    if (!tracking) co_return tracking;
    // The arm itself may hide it, if it stands low before it.
    if (!*found && stands_low() && !out_of_the_way) {
      const Result<void> raised = co_await runner_.raise();
      if (!raised && ends_search(raised.error())) co_return raised;
      // One that ended early is tried again while there is time.
      out_of_the_way = raised.has_value();
    }
    const bool may_set_aside = set_aside.done.size() < most_set_aside && set_aside_ < most_set_aside_of_goal;
    if (may_set_aside && context_.executor.now() > doubtful) {
      const Result<bool> cleared = co_await clear_view(object, set_aside);
      if (!cleared) co_return fail(cleared);
      doubtful = context_.executor.now() + look_behind;
      const bool goes_on = *cleared || !looked_behind;
      if (goes_on) deadline = context_.executor.now() + options_.missing_patience;
      looked_behind = true;
    }
    // Found in one image alone, it has no place, and that is as good as not seen. While the eyes or the board were away
    // nobody looked, so that the time alone is no proof.
    if (context_.executor.now() > deadline) {
      const Failure why = missing_objects({object});
      co_return fail(why);
    }
    const Result<void> looked = co_await eyes_.fresh_look();
    if (!looked) co_return looked;
  }
}

// Where a thing is nowhere to be seen, the gripper may hold it, or another may stand before it. That a try fails is no
// reason to give up looking; one that somebody's stop kept from being made is to be made yet.
Task<Result<bool>> Pursuit::clear_view(std::string missing, SetAside& set_aside) {
  Result<void> done = co_await rescues_.lay_down(missing);
  // A plan was made when all of the goal's objects had been found.
  const bool was_here = current_ && planned_for_ == current_->number;
  const std::optional<std::string> before = surroundings_.scene().may_hide(missing, set_aside.done, was_here);
  const bool may_hide = done && before && *before != missing;
  if (may_hide) {
    ++set_aside_;
    const std::optional<std::string> under = surroundings_.scene().under(*before);
    done = co_await rescues_.set_aside(*before);
    const bool hides_again = done && !hid_.emplace(missing, *before).second;
    const bool under_too = hides_again && under && *under != missing;
    if (under_too) done = co_await rescues_.set_aside(*under);
    const bool in_vain = !done && ++set_aside.failed[*before] == tries_to_set_aside;
    if (done || in_vain) set_aside.done.insert(*before);
  }
  if (done) co_return may_hide;
  if (ends_search(done.error())) co_return fail(done);
  const std::string sentence = "the rescue failed: " + done.error().sentence;
  const Datum why = failure_to_datum(done.error());
  co_await story_.tell("servo", sentence, why);
  co_return may_hide;
}

// A hand may be at work: what is planned on should have come to rest. Not for ever.
Task<void> Pursuit::await_steady(std::vector<std::string> objects) {
  const Time deadline = context_.executor.now() + steady_patience;
  while (!surroundings_.steady(objects) && context_.executor.now() < deadline && !vigil_.interrupted()) {
    const Result<void> looked = co_await eyes_.fresh_look();
    if (!looked) co_return;
  }
}

// Steps d to f. That there is no plan counts when it is proved twice, in case something was on its way.
Task<Result<bool>> Pursuit::plan_anew(Goal goal, std::vector<std::string> objects) {
  const Result<void> there = co_await look_for(objects);
  if (!there) co_return fail(there);
  co_await await_steady(objects);
  // Whoever disturbed may have put things right again.
  const Result<std::optional<NextOperation>> still_serves = co_await hand_out(goal.number);
  if (!still_serves) co_return fail(still_serves);
  if (*still_serves) co_return false;
  bool proved = false;
  int failed = 0;
  for (int attempt = 0; attempt < most_attempts; ++attempt) {
    if (vigil_.interrupted()) co_return fail("interrupted", "another goal, or none, is wanted now");
    const Facts planned_on = surroundings_.beliefs();
    Result<std::vector<Datum>> plan = co_await planning_.make_plan(goal.number, goal.facts);
    if (plan) {
      co_await tell_plan(goal.number, std::move(*plan));
      co_return true;
    }
    if (is_verdict(plan.error()) && (proved || plan.error().symbol == "absent")) co_return fail(plan);
    proved = is_verdict(plan.error());
    // A cube that is held askew is neither held nor lying anywhere, as far as the eyes can tell. What comes of it is
    // seen.
    const bool may_hold = proved && !objects.empty();
    Result<void> laid;
    if (may_hold) laid = co_await rescues_.lay_down(objects.front());
    if (!laid && ends_search(laid.error())) co_return fail(laid);
    // An object that the gripper hides is believed to be where it was, and may have fallen. The second proof is made
    // on what is seen with the arm raised. What does not show then is looked for.
    if (proved) surroundings_.doubt_hidden();
    const bool may_hide = proved && stands_low();
    Result<void> raised;
    if (may_hide) raised = co_await runner_.raise();
    if (!raised && ends_search(raised.error())) co_return fail(raised);
    if (!proved) ++failed;
    if (failed == planner_tries) co_return fail(plan);
    const Duration pause = proved ? second_proof_after : planner_pause;
    co_await sleep(context_.executor, pause);
    co_await await_steady(objects);
    if (surroundings_.beliefs() != planned_on) proved = false;
    const Result<void> still_there = co_await look_for(objects);
    if (!still_there) co_return fail(still_there);
  }
  co_return fail("gave-up", "the cell does not come to rest, and none of the states it was seen in has a plan");
}

Task<void> Pursuit::tell_plan(std::int64_t goal, std::vector<Datum> operations) {
  std::string told;
  for (const Datum& operation : operations) told += ' ' + write(operation);
  const bool again = planned_for_ == goal;
  planned_for_ = goal;
  const std::string sentence =
      operations.empty() ? "nothing needs to be done" : fmt::format("{}:{}", again ? "new plan" : "plan", told);
  const Datum detail = list("plan"_sym, goal, Datum::list(std::move(operations)));
  co_await story_.tell("plan", sentence, detail);
}

Task<void> Pursuit::resume() {
  const Datum any = "?"_sym;
  const std::vector<Fact> goals = co_await facts_now(context_.board, context_.executor, list("goal"_sym, any, any));
  std::vector<Fact> states =
      co_await facts_now(context_.board, context_.executor, list("goal-state"_sym, any, any, any));
  std::erase_if(states, [](const Fact& state) { return !is_in_hand(state.datum[2]); });
  std::optional<Goal> goal;
  for (const Fact& fact : goals) {
    const std::int64_t number = fact.datum[1].integer();
    last_number_ = std::max(last_number_, number);
    const bool running =
        std::ranges::any_of(states, [&](const Fact& state) { return state.datum[1] == fact.datum[1]; });
    const auto wanted = fact.datum[2].items();
    if (running) goal = Goal{number, {wanted.begin(), wanted.end()}, stage_of(states, number)};
  }
  if (!goal) co_return;
  current_ = goal;
  // The plan may be that of the stage before.
  planned_for_ = goal->stage == 0 ? goal->number : 0;
  const std::string sentence = fmt::format("going on with goal {} after a restart", goal->number);
  co_await story_.tell("agent", sentence, to_datum(goal->number));
}

}  // namespace pizarra::coordinator
