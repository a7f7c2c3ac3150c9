#pragma once

// One action after another, told as steps.
//
//   outcome.steps = in_parallel(problem, plan);

#include "agents/planner/distance/compact_problem.hpp"

namespace pizarra::planner {

// Every action in the first step that its order with those before it allows.
std::vector<std::vector<std::size_t>> in_parallel(const Problem& problem, const std::vector<ActionIndex>& plan);

}  // namespace pizarra::planner
