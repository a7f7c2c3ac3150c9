#pragma once

// Breadth-first search over states, one parallel step at a time. States that differ only by exchanging objects that are
// alike count as one. For problems with few states, however long their plans.
//
//   StepSearch engine;
//   const Outcome outcome = engine.solve(problem, budget, cancelled);
//
// Budget::nodes counts steps looked at. Gives up at once where a state has too many steps to look at.

#include "agents/planner/task/problem.hpp"

namespace pizarra::planner {

// A shortest parallel plan. The culprits of `none` are all the goals.
class StepSearch : public PlanEngine {
 public:
  Outcome solve(const Problem& problem, const Budget& budget, const std::function<bool()>& cancelled) override;
};

}  // namespace pizarra::planner
