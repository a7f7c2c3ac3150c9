#pragma once

// The shortest plan, by OptimalSearch; without one, the fewest goals that its searches find to blame.
//
//   OptimalPlanner planner;
//   const Outcome outcome = planner.solve(problem, Budget{}, [] { return false; });

#include "agents/planner/optimal/optimal_search.hpp"

namespace pizarra {

class OptimalPlanner : public PlanEngine {
 public:
  // The culprits of `none` are goals that cannot be reached together, while any of them could be left out, as far as
  // the searches prove it within the budget.
  Outcome solve(const Problem& problem, const Budget& budget, const std::function<bool()>& cancelled) override;
};

// The culprits of an outcome of `none` without those that the rest cannot be reached without anyway, as far as some
// work shows; those found so far where it is cancelled.
void blame_fewest(const Problem& problem, const Budget& budget, const std::function<bool()>& cancelled,
                  Outcome& outcome);

}  // namespace pizarra
