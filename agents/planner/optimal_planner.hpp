#pragma once

// The shortest plan, by whichever search suits the problem:
//
//   guided     every action needs one resource: A* under the landmark bound (blocks world, with hundreds of facts)
//   stepwise   few states, however long the plan: breadth-first over parallel steps (hanoi, gripper)
//   sat        everything else: satisfiability, one number of steps after another (logistics)
//
//   OptimalPlanner planner;
//   const Outcome outcome = planner.solve(problem, Budget{}, [] { return false; });
//   outcome.engine;                                  // which of them answered
//
// A plan has the fewest parallel steps there can be; `none` is proved, with goals as few as the searches could make out
// that cannot be reached together.

#include <optional>

#include "agents/planner/dead_ends.hpp"

namespace pizarra {

class OptimalPlanner : public PlanEngine {
 public:
  Outcome solve(const Problem& problem, const Budget& budget, const std::function<bool()>& cancelled) override;
};

// No plan has fewer actions, nor fewer steps: the best landmark bound of any resource. None: there is no plan.
std::optional<std::size_t> fewest_actions(const Problem& problem);

}  // namespace pizarra
