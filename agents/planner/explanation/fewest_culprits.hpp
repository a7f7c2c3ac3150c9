#pragma once

// Goals that cannot be reached together, none of which could be left out.
//
//   Outcome outcome = engine.solve(problem, budget, cancelled);
//   blame_fewest(problem, budget, cancelled, outcome);

#include "agents/planner/task/problem.hpp"

namespace pizarra::planner {

// The culprits of an outcome of `none` without those that the rest cannot be reached without anyway, as far as some
// work shows; those found so far where it is cancelled.
void blame_fewest(const Problem& problem, const Budget& budget, const std::function<bool()>& cancelled,
                  Outcome& outcome);

}  // namespace pizarra::planner
