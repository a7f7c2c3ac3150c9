#pragma once

// Is there any plan from this state? A breadth-first search over whole states, one action at a time: slower than
// Graphplan where plans are long, and so simple that it may judge it.
//
//   BreadthFirst judge;
//   if (judge.solve(problem, Budget{}, never).kind == Outcome::Kind::none) ...    // refused correctly

#include "agents/planner/task/problem.hpp"

namespace pizarra::planner {

// A shortest sequential plan, every step one action. Budget::nodes counts states. The culprits of `none` are all goals.
class BreadthFirst : public PlanEngine {
 public:
  Outcome solve(const Problem& problem, const Budget& budget, const std::function<bool()>& cancelled) override;
};

// Whether the task has a plan at all: true, false, or a failure: `gave-up`, or what ground() says of the task.
Result<bool> any_plan(const PlanningTask& task, const Budget& budget = {});

}  // namespace pizarra::planner
