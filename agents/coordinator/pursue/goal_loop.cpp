#include "agents/coordinator/pursue/goal_loop.hpp"

namespace pizarra::coordinator {

Task<void> GoalLoop::resume() {
  co_await goal_.resume();
  const std::optional<Goal>& taken_up = goal_.current();
  // The plan may be that of the stage before.
  if (taken_up && taken_up->stage == 0) plan_.take_up(taken_up->number);
}

Task<void> GoalLoop::run() {
  while (true) {
    const Goal goal = co_await goal_.next();
    interruption_.clear();
    const Result<void> outcome = co_await pursue(goal);
    co_await goal_.finish(goal, outcome);
  }
}

Task<Result<void>> GoalLoop::pursue(Goal goal) {
  const StagedGoal staged = staged_goal_of(goal.facts);
  if (staged.keeps) {
    const Result<void> ended = co_await kept_.keep(goal, staged);
    co_return ended;
  }
  const Result<void> outcome = co_await pursuit_.run(goal, staged);
  co_return outcome;
}

}  // namespace pizarra::coordinator
