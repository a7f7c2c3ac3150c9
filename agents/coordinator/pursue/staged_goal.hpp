#pragma once

// A checked goal (lisp/forms/goal.hpp) as it is pursued: its stages, whether it stands for good, and how long a missing
// object is waited for.
//
//   const StagedGoal staged = staged_goal_of({(keep (on a b)), (wait 60)});
//   staged.stages.size(); staged.keeps; staged.patience;       // 1; true; 60 s

#include <vector>

#include "blackboard/time/clock.hpp"
#include "lisp/datum.hpp"

namespace pizarra::coordinator {

struct StagedGoal {
  std::vector<std::vector<Datum>> stages;  // each a goal as lisp/forms/goal_formula.hpp has them
  bool keeps = false;                      // what falls is built again
  Duration patience{};                     // for missing objects
};

StagedGoal staged_goal_of(const std::vector<Datum>& goal);

}  // namespace pizarra::coordinator
