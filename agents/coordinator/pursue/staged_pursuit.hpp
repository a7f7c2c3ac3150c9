#pragma once

// Pursues a goal stage by stage. An object that is missing is waited for, where the goal says for how long.
//
//   StagedPursuit staged(context, surroundings, eyes, plan, goal_in_hand, pursuit, interruption);
//   Result<void> outcome = co_await staged.run(goal, staged_goal_of(goal.facts));

#include "agents/coordinator/pursue/pursuit.hpp"
#include "agents/coordinator/pursue/staged_goal.hpp"

namespace pizarra::coordinator {

class StagedPursuit {
 public:
  StagedPursuit(runtime::AgentContext& context, Surroundings& surroundings, Eyes& eyes, PlanInHand& plan,
                GoalInHand& goal, Pursuit& pursuit, const Interruption& interruption)
      : context_(context),
        surroundings_(surroundings),
        eyes_(eyes),
        plan_(plan),
        goal_(goal),
        pursuit_(pursuit),
        interruption_(interruption) {}

  // Begins with the goal's stage. Failures: Pursuit::run()'s.
  Task<Result<void>> run(Goal goal, StagedGoal staged);

 private:
  // Waits for what is missing, as often as something is, as long as its patience lasts each time.
  Task<Result<void>> pursue_patiently(Goal goal, Duration patience);
  Task<Result<void>> await_missing(Goal goal, Failure missing, Duration patience);

  runtime::AgentContext& context_;
  Surroundings& surroundings_;
  Eyes& eyes_;
  PlanInHand& plan_;
  GoalInHand& goal_;
  Pursuit& pursuit_;
  const Interruption& interruption_;
};

}  // namespace pizarra::coordinator
