#pragma once

// Why a fact can never hold: the chain down to what is missing, in a sentence.
//
//   why_never(task, problem, fact, cancelled)
//   // "(holding c) needs (clear c), and (clear c) neither holds at the beginning nor is brought about by any operator"

#include "agents/planner/task/problem.hpp"

namespace pizarra::planner {

// For a fact, or `(not FACT)`, of which it was proved that it never holds. The chain ends in a fact that is missing at
// the beginning; a type without objects; an object of another type; an operator that no objects suit; a cost without a
// value; or an action whose needs never hold together. Cancelled, it says what it has found out.
std::string why_never(const PlanningTask& task, const Problem& problem, const Datum& fact,
                      const std::function<bool()>& cancelled);

}  // namespace pizarra::planner
