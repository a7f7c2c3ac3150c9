#pragma once

// OptimalSearch for one plan alone.
//
//   OptimalPlanner planner;
//   const Outcome outcome = planner.solve(problem, Budget{}, [] { return false; });

#include "agents/planner/optimal/optimal_search.hpp"

namespace pizarra::planner {

class OptimalPlanner : public PlanEngine {
 public:
  Outcome solve(const Problem& problem, const Budget& budget, const std::function<bool()>& cancelled) override {
    return OptimalSearch(problem).run(budget, cancelled);
  }
};

}  // namespace pizarra::planner
