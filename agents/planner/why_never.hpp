#pragma once

// Why a fact can never hold: the chain down to what is missing, in a sentence.
//
//   why_never(task, problem, fact)
//   // "(holding c) needs (clear c), and no operator brings about (clear c)"

#include "agents/planner/task/problem.hpp"

namespace pizarra {

// For a fact that even without any delete cannot be reached. Empty where no single precondition is to blame.
std::string why_never(const PlanningTask& task, const Problem& problem, const Datum& fact);

}  // namespace pizarra
