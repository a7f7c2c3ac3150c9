#pragma once

// Goals that the invariants alone say can never hold, found in one pass over the actions: what a search through all
// states would prove, but hardly within anyone's patience for a large problem.
//
//   const std::vector<std::size_t> culprits = impossible_goals(compact, invariants);
//
// An action that needs two facts that exclude each other can never be taken; a goal that the others, their deletes
// forgotten, do not reach never holds.

#include "agents/planner/distance/invariant_groups.hpp"

namespace pizarra::planner {

// The first goal that can never hold, or else the first two that never hold together; empty where none is known.
std::vector<std::size_t> impossible_goals(const CompactProblem& problem, const InvariantGroups& invariants);

}  // namespace pizarra::planner
