#pragma once

// What is done to a plan once it is found.
//
//   const std::vector<ActionIndex> lean = without_idle_actions(compact, plan);
//   outcome.steps = in_parallel(problem, lean);

#include "agents/planner/distance/compact_problem.hpp"

namespace pizarra {

// Leaves out every action that, with those which need what it made true, is not needed for the goals (Nakhost and
// Mueller 2010).
std::vector<ActionIndex> without_idle_actions(const CompactProblem& problem, std::vector<ActionIndex> plan);

// Every action in the first step that its order with those before it allows.
std::vector<std::vector<std::size_t>> in_parallel(const Problem& problem, const std::vector<ActionIndex>& plan);

}  // namespace pizarra
