#pragma once

// Has a new plan made (steps d to f). That there is none counts when it is proved twice, in case something was on its
// way, or hidden by the gripper.
//
//   Replanning replanning(context, surroundings, planning, plan, search, runner, rescues, interruption);
//   Result<bool> made = co_await replanning.run(goal, objects);       // false where the one in hand serves again

#include <string>
#include <vector>

#include "agents/coordinator/pursue/goal_in_hand.hpp"
#include "agents/coordinator/pursue/object_search.hpp"

namespace pizarra::coordinator {

class Replanning {
 public:
  Replanning(runtime::AgentContext& context, Surroundings& surroundings, Planning& planning, PlanInHand& plan,
             ObjectSearch& search, TaskRunner& runner, Rescues& rescues, const Interruption& interruption)
      : context_(context),
        surroundings_(surroundings),
        planning_(planning),
        plan_(plan),
        search_(search),
        runner_(runner),
        rescues_(rescues),
        interruption_(interruption) {}

  // Failures: no-plan, gave-up, absent, those of the search, and hold-ups.
  Task<Result<bool>> run(Goal goal, std::vector<std::string> objects);

 private:
  // Changes the scene where what cannot be seen may be why there is no plan.
  Task<Result<void>> show_what_is_hidden(std::vector<std::string> objects);

  runtime::AgentContext& context_;
  Surroundings& surroundings_;
  Planning& planning_;
  PlanInHand& plan_;
  ObjectSearch& search_;
  TaskRunner& runner_;
  Rescues& rescues_;
  const Interruption& interruption_;
};

}  // namespace pizarra::coordinator
