#pragma once

// Why an engine came back without a plan, for people and programs.
//
//   if (outcome.kind != Outcome::Kind::plan) return fail(explain(problem, outcome));

#include "agents/planner/task/problem.hpp"

namespace pizarra::planner {

// `no-plan` with the goals that exclude each other as the subject, `gave-up` or `cancelled`. Not for an outcome that is
// a plan.
Failure explain(const Problem& problem, const Outcome& outcome);

}  // namespace pizarra::planner
