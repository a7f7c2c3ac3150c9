#pragma once

// The planner: takes operators and facts, plans, and hands out one operation at a time (docs/facts.md).
//
// Lifecycle: constructed, run() spawned. What it was told and its plan are in memory alone: after a restart it answers
// `not-ready`, and whoever asked tells it again. The search runs away from the agents' thread, so requests are answered
// meanwhile; a newer get-operations, get-facts or get-plan cancels it, and the one that waited for it is answered
// `cancelled`.
//
// Plans have the fewest parallel steps there can be, or, for problems too large, are some plan made fast: the fact
// `planner` says which. Plans made again after the facts have changed are no longer for that: they come from what is
// known of the task already (replanner.hpp), unless its operators, objects or goals have changed as well.
//
//   (get-operations ((operator PICK-UP (params (<ob1> OBJECT)) (preconds ...) (effects ... (del ...))) ...))  -> (ok)
//   (get-facts (types (circle OBJECT) ...) (initials (clear circle) ...) (goals (on circle square) ...))      -> (ok)
//   (get-plan)         -> (ok (((PICK-UP circle)) ((STACK circle square))))
//   (start-plan)       -> (ok (PICK-UP circle))
//   (next-operation 1) -> (ok (STACK circle square)), (next-operation 2) -> (ok done)
//
// Failures: bad-operator, bad-facts, bad-task, unknown-object, unknown-predicate, too-large, not-ready, bad-index,
// no-plan (proved; the subject is the goals that exclude each other), gave-up, cancelled.

#include <memory>

#include "agents/planner/task/problem.hpp"
#include "agents/runtime/agent.hpp"

namespace pizarra::planner {

class PlannerAgent : public runtime::Agent {
 public:
  explicit PlannerAgent(runtime::AgentContext context, Budget budget = {});
  ~PlannerAgent() override;
  Task<Result<void>> run() override;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace pizarra::planner
