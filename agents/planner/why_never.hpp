#pragma once

// Why a fact can never hold: the chain down to what is missing, in a sentence.
//
//   why_never(task, problem, fact, cancelled)
//   // "(holding c) needs (clear c), and (clear c) neither holds at the beginning nor is brought about by any operator"

#include "agents/planner/task/problem.hpp"

namespace pizarra {

// For a fact, or `(not FACT)`, that even without any delete cannot be reached; empty for any other. It ends in a fact
// that is missing at the beginning, a type without objects, or an operator that no objects suit. Cancelled, it
// says what it has found out.
std::string why_never(const PlanningTask& task, const Problem& problem, const Datum& fact,
                      const std::function<bool()>& cancelled);

}  // namespace pizarra
