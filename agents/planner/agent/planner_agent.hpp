#pragma once

// The planner: takes operators and facts, makes a plan, owns it, and hands out the operation to do next, which follows
// from what holds (docs/facts/planner.md).
//
// Lifecycle: constructed, run() spawned. Its plan is durable facts: killed and made anew it goes on with the plan that
// it had. The operators and facts that it was told by get-operations and get-facts are in memory alone. The search runs
// away from the agents' thread, so requests are answered meanwhile; a newer get-operations, get-facts, get-plan or
// make-plan cancels it, and the one that waited for it is answered `cancelled`.
//
// Plans have the fewest parallel steps there can be, or, for problems too large, are some plan made fast: the fact
// `planner` says which. A plan made again after the facts have changed is as short as another, and comes soon: what is
// known of the task is used again (replanner.hpp), unless its operators, objects or goals have changed as well.
//
//   (get-operations ((operator PICK-UP (params (<ob1> OBJECT)) (preconds ...) (effects ... (del ...))) ...))  -> (ok)
//
//   (get-facts (types (circle OBJECT) ...) (initials (clear circle) ...) (goals (on circle square) ...))      -> (ok)
//
//   (get-plan)         -> (ok (((PICK-UP circle)) ((STACK circle square))))
//   (start-plan)       -> (ok (PICK-UP circle))
//   (make-plan 7 (OPERATOR ...) (types ...) (initials ...) (goals ...))            -> as get-plan, and it is started
//
//   (next-operation 7 (FACT ...))
//       -> (ok 1 ((STACK circle square)) ((holding circle) ...) ((on circle square) ...))
//
// `next-operation` answers the index of the operation to do next, that one and those after it, and what must hold
// before and after it for them to reach the goals.
//
// A goal is a fact or a formula of facts (lisp/forms/goal_formula.hpp), quantified over the objects of `types`.
//
// Failures: bad-operator, bad-facts, bad-task, unknown-object, unknown-predicate, too-large, not-ready, off-plan
// (no end of the plan serves from what holds), no-plan (proved; the subject is the goals that exclude each other),
// gave-up, cancelled.

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
