#pragma once

// The dialogue with the planning server (steps d to h). The planner owns the plan of the goal in hand. It is told what
// is seen, and hands out the operation to do next.
//
//   Result<NextOperation> next = co_await planning.next(goal);      // off-plan, not-ready: another plan must be made
//   Result<std::vector<Datum>> plan = co_await planning.make_plan(goal, facts);

#include "agents/coordinator/perceive/surroundings.hpp"
#include "agents/runtime/roles.hpp"
#include "lisp/forms/goal_formula.hpp"

namespace pizarra::coordinator {

struct NextOperation {
  std::size_t index = 0;              // within the plan
  std::vector<GroundOperation> rest;  // it, and what comes after it; empty: the goal holds
  Facts needed;                       // before it, for these to reach the goal
  Facts needed_after;                 // the same after it
};

class Planning {
 public:
  Planning(runtime::AgentContext& context, const CoordinatorOptions& options, const TaskDomain& domain,
           runtime::Roles& roles, runtime::Caller& caller, const Surroundings& surroundings)
      : context_(context),
        options_(options),
        domain_(domain),
        roles_(roles),
        caller_(caller),
        surroundings_(surroundings) {}

  // Has a plan made from what is believed now, and answers its operations, one after another; none where the goal
  // holds. Failures: no-plan (proved), gave-up, absent, and what the planner says of a task it cannot read.
  Task<Result<std::vector<Datum>>> make_plan(std::int64_t goal, std::vector<Datum> facts);
  // The same of a plan that is only thought of, from facts that need not be believed: nothing is kept, and the plan in
  // use goes on.
  Task<Result<std::vector<Datum>>> try_plan(std::vector<Datum> facts, Facts from);
  // The objects that are seen, and those that the domain says are always there, with their types. A goal quantifies
  // over these.
  forms::TypedObjects objects() const;
  // From the beliefs of now. Failures: off-plan, where no end of the goal's plan serves; not-ready, where it has none;
  // absent.
  Task<Result<NextOperation>> next(std::int64_t goal);

 private:
  Task<Result<Datum>> ask(Datum operation, Duration patience);
  Task<Result<std::vector<Datum>>> plan_of(Datum question);
  Datum question(std::vector<Datum> head, std::vector<Datum> goal, const Facts& from) const;
  Datum operators() const;
  Datum types() const;
  Datum holding(std::string_view head, const Facts& from) const;
  Result<NextOperation> read(const Datum& reply) const;

  runtime::AgentContext& context_;
  const CoordinatorOptions& options_;
  const TaskDomain& domain_;
  runtime::Roles& roles_;
  runtime::Caller& caller_;
  const Surroundings& surroundings_;
};

}  // namespace pizarra::coordinator
