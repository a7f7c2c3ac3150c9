#pragma once

// The actions that a foreign planner wrote, in whatever way planners write them, names in lower case:
//
//   (pick-up b1)               Fast Downward, and most others; behind it a `; comment` or `[1]`
//   0: (PICK-UP B1) [1]        temporal planners
//   step    0: PICK-UP B1      FF; the word `step` only once
//   STEP 0: pick-up(b1) stack(b1,b2)       Madagascar
//   pick-up b1 (1)             Fast Downward's log
//
//   const PlanActions actions = find_actions(output, {{"pick-up", 1}, {"stack", 2}});

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "lisp/result.hpp"

namespace pizarra::pddl_planner {

// An operator's name and its objects'.
using PlanActions = std::vector<std::vector<std::string>>;
// The operators' names in lower case and how many objects each takes.
using PlanOperators = std::map<std::string, std::size_t, std::less<>>;

// Among other text: what is no operator with so many objects is passed over, and a plan numbered from 0 again replaces
// the one before.
PlanActions find_actions(std::string_view text, const PlanOperators& operators);

// Where nothing but a plan should be. Fails with `garbage` at a line that is no action.
Result<PlanActions> read_actions(std::string_view text, const PlanOperators& operators);

}  // namespace pizarra::pddl_planner
