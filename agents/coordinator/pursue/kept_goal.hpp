#pragma once

// A goal that is to be kept, (keep GOAL): what falls is built again. While it cannot be had, the arm rests, and it is
// tried again when something has changed.
//
//   KeptGoal kept(context, options, surroundings, eyes, planning, differences, goal_in_hand, staged_pursuit,
//                 interruption);
//   Result<void> ended = co_await kept.keep(goal, staged_goal_of(goal.facts));       // interrupted

#include "agents/coordinator/pursue/staged_pursuit.hpp"

namespace pizarra::coordinator {

class KeptGoal {
 public:
  KeptGoal(runtime::AgentContext& context, const CoordinatorOptions& options, Surroundings& surroundings, Eyes& eyes,
           Planning& planning, Differences& differences, GoalInHand& goal, StagedPursuit& pursuit,
           const Interruption& interruption)
      : context_(context),
        options_(options),
        surroundings_(surroundings),
        eyes_(eyes),
        planning_(planning),
        differences_(differences),
        goal_(goal),
        pursuit_(pursuit),
        interruption_(interruption) {}

  Task<Result<void>> keep(Goal goal, StagedGoal staged);

 private:
  // Until something changes after which a goal that cannot be had may be tried again. The failure that stands told, so
  // that it is told once.
  Task<Failure> keep_in_mind(std::int64_t goal, Failure why, Failure told);
  // After a search in vain: until a missing object shows, or somebody moved another one. Nothing is done meanwhile.
  Task<void> await_sight(std::int64_t goal, Failure missing);
  // Until something believed changes, or a while.
  Task<void> await_change();

  runtime::AgentContext& context_;
  const CoordinatorOptions& options_;
  Surroundings& surroundings_;
  Eyes& eyes_;
  Planning& planning_;
  Differences& differences_;
  GoalInHand& goal_;
  StagedPursuit& pursuit_;
  const Interruption& interruption_;
};

}  // namespace pizarra::coordinator
