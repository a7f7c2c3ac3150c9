#pragma once

// Some plan soon, then shorter ones for as long as it may go on: for problems too large for the shortest plan.
//
//   FastPlanner engine({.better = [](const Outcome& plan) { ... }});
//   const Outcome best = engine.solve(problem, Budget{}, cancelled);
//
// Counts actions, not steps. For the first plan a greedy search asks cheaply how far states are; where it comes no
// nearer, one that asks more climbs by helpful actions; and where that gives up, the greedy one goes on through all
// states if it has to, so that `none` is proved. Where one resource bounds the plans, the shortest is looked for under
// that bound, and proved to be that. Else the plan's own actions are tried in other orders. Then beams, each twice as
// wide as the last, look for plans with fewer actions, until the budget is spent, the caller cancels, or a beam left
// nothing out: the plan is then as short as can be. A call that is cancelled, or spends its budget, after the first
// plan was found answers its best one; so does one to which std::bad_alloc happens.

#include "agents/planner/distance/nearness.hpp"

namespace pizarra::planner {

struct FastPlannerOptions {
  std::uint64_t seed = 1;
  // Told of the first plan and of every better one, while solve() runs.
  std::function<void(const Outcome&)> better = {};
  bool first_only = false;
};

class FastPlanner : public PlanEngine {
 public:
  explicit FastPlanner(FastPlannerOptions options = {}) : options_(std::move(options)) {}
  // Budget::nodes counts states whose distance is asked, and actions redone. The culprits of `none` are those that the
  // invariants name (impossible_goals.hpp), or all the goals.
  Outcome solve(const Problem& problem, const Budget& budget, const std::function<bool()>& cancelled) override;
  // Uses the nearness that is known, which begins where the problem does.
  Outcome solve(const Problem& problem, Nearness& nearness, const Budget& budget,
                const std::function<bool()>& cancelled);
  // Of a plan of the problem, what is needed, in as few actions as trying other orders gives. Neither beams nor proofs
  // are tried.
  Outcome shorten(const Problem& problem, Nearness& nearness, const std::vector<ActionIndex>& plan,
                  const Budget& budget, const std::function<bool()>& cancelled);

 private:
  const FastPlannerOptions options_;
};

}  // namespace pizarra::planner
