#pragma once

// The facts that can hold and the actions that can be done if nothing were ever deleted.
//
//   const std::vector<char> reachable = drop_unreachable(actions, holds_at_first);

#include "agents/planner/task/problem.hpp"

namespace pizarra::planner {

// Of every fact, whether it can hold; actions that can then never be taken are dropped.
std::vector<char> drop_unreachable(std::vector<GroundAction>& actions, const std::vector<char>& initially);

}  // namespace pizarra::planner
