#pragma once

// Graphplan: a shortest parallel plan, or the proof that there is none.
//
//   Graphplan engine;
//   Outcome outcome = engine.solve(problem, Budget{}, [] { return false; });

#include "agents/planner/task/problem.hpp"

namespace pizarra::planner {

class Graphplan : public PlanEngine {
 public:
  Outcome solve(const Problem& problem, const Budget& budget, const std::function<bool()>& cancelled) override;
};

}  // namespace pizarra::planner
