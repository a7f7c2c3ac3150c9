#pragma once

// Goes on for ever, one goal after another: to its end, or for ever where it is to be kept.
//
//   GoalLoop loop(plan, goal_in_hand, staged_pursuit, kept_goal, interruption);
//   co_await loop.resume();                     // the goal and the plan that stand on the board
//   Job job = executor.spawn(loop.run());

#include "agents/coordinator/pursue/kept_goal.hpp"

namespace pizarra::coordinator {

class GoalLoop {
 public:
  GoalLoop(PlanInHand& plan, GoalInHand& goal, StagedPursuit& pursuit, KeptGoal& kept, Interruption& interruption)
      : plan_(plan), goal_(goal), pursuit_(pursuit), kept_(kept), interruption_(interruption) {}

  Task<void> resume();
  Task<void> run();

 private:
  Task<Result<void>> pursue(Goal goal);

  PlanInHand& plan_;
  GoalInHand& goal_;
  StagedPursuit& pursuit_;
  KeptGoal& kept_;
  Interruption& interruption_;
};

}  // namespace pizarra::coordinator
