#pragma once

// Goes on for ever, one goal after another. A goal may take longer than a plan: its stages are pursued one after
// another, what is missing is waited for, and what is to be kept is built again when it falls.
//
//   GoalLoop loop(context, options, surroundings, eyes, planning, plan, differences, goal, pursuit, vigil);
//   co_await loop.resume();                     // the goal and the plan that stand on the board
//   Job job = executor.spawn(loop.run());

#include "agents/coordinator/pursue/pursuit.hpp"
#include "agents/coordinator/pursue/staged_goal.hpp"

namespace pizarra::coordinator {

class GoalLoop {
 public:
  GoalLoop(runtime::AgentContext& context, const CoordinatorOptions& options, Surroundings& surroundings, Eyes& eyes,
           Planning& planning, PlanInHand& plan, Differences& differences, GoalInHand& goal, Pursuit& pursuit,
           Vigil& vigil)
      : context_(context),
        options_(options),
        surroundings_(surroundings),
        eyes_(eyes),
        planning_(planning),
        plan_(plan),
        differences_(differences),
        goal_(goal),
        pursuit_(pursuit),
        vigil_(vigil) {}

  Task<void> resume();
  Task<void> run();

 private:
  // All of its stages, and for ever where it is to be kept.
  Task<Result<void>> pursue(Goal goal);
  Task<Result<void>> pursue_stages(Goal goal, StagedGoal staged);
  // Waits for what is missing, as often as something is, as long as its patience lasts each time.
  Task<Result<void>> pursue_patiently(Goal goal, Duration patience);
  Task<Result<void>> await_missing(Goal goal, Failure missing, Duration patience);
  Task<Result<void>> keep(Goal goal, StagedGoal staged);
  // Until something changes that a kept goal which cannot be had may be tried again after. The failure that stands
  // told, so that it is told once.
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
  PlanInHand& plan_;
  Differences& differences_;
  GoalInHand& goal_;
  Pursuit& pursuit_;
  Vigil& vigil_;
};

}  // namespace pizarra::coordinator
