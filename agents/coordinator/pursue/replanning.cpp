#include "agents/coordinator/pursue/replanning.hpp"

namespace pizarra::coordinator {

namespace {

constexpr Duration second_proof_after = 2s;
constexpr Duration planner_pause = 1s;
constexpr int planner_tries = 3;
constexpr int most_attempts = 12;

bool is_verdict(const Failure& failure) {
  return failure.symbol == "no-plan" || failure.symbol == "gave-up" || failure.symbol == "absent";
}

}  // namespace

Task<Result<bool>> Replanning::run(Goal goal, std::vector<std::string> objects) {
  const Result<void> there = co_await search_.look_for(goal);
  if (!there) co_return fail(there);
  co_await search_.await_steady(objects);
  // Whoever disturbed may have put things right again.
  const Result<std::optional<NextOperation>> still_serves = co_await plan_.next(goal.number);
  if (!still_serves) co_return fail(still_serves);
  if (*still_serves) co_return false;
  bool proved = false;
  int failed = 0;
  for (int attempt = 0; attempt < most_attempts; ++attempt) {
    if (interruption_.raised()) co_return interruption_.failure();
    const Facts planned_on = surroundings_.beliefs();
    Result<std::vector<Datum>> plan = co_await planning_.make_plan(goal.number, goal.facts);
    if (plan) {
      co_await plan_.tell(goal.number, std::move(*plan));
      co_return true;
    }
    const bool is_absent = plan.error().symbol == "absent";
    if (is_verdict(plan.error()) && (proved || is_absent)) co_return fail(plan);
    proved = is_verdict(plan.error());
    if (!proved) ++failed;
    if (proved) co_await search_.await_put_down();
    Result<void> shown;
    if (proved) shown = co_await show_what_is_hidden(objects);
    const bool looks_on = proved && shown;
    if (looks_on) shown = co_await search_.look_for_others(goal);
    if (!shown && ends_search(shown.error())) co_return fail(shown);
    // There may be no plan only because something stays hidden.
    if (!shown) proved = false;
    if (failed == planner_tries) co_return fail(plan);
    const Duration pause = proved ? second_proof_after : planner_pause;
    co_await sleep(context_.executor, pause);
    co_await search_.await_steady(objects);
    if (surroundings_.beliefs() != planned_on) proved = false;
    const Result<void> still_there = co_await search_.look_for(goal);
    if (!still_there) co_return fail(still_there);
  }
  co_return fail("gave-up", "the cell does not come to rest, and none of the states it was seen in has a plan");
}

Task<Result<void>> Replanning::show_what_is_hidden(std::vector<std::string> objects) {
  // A cube that is held askew is neither held nor lying anywhere, as far as the eyes can tell. What comes of it is
  // seen.
  Result<void> laid;
  if (!objects.empty()) laid = co_await rescues_.lay_down(objects.front());
  if (!laid) co_return laid;
  // An object that the gripper hides is believed to be where it was, and may have fallen. The second proof is made
  // on what is seen with the arm raised. What does not show then is looked for.
  surroundings_.doubt_hidden();
  Result<void> raised;
  if (search_.arm_stands_low()) raised = co_await runner_.raise();
  co_return raised;
}

}  // namespace pizarra::coordinator
