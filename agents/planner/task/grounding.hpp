#pragma once

// A planning task as a grounded problem: its operators with every suitable object in place of their parameters.
//
//   const Result<Problem> problem = ground(task);

#include "agents/planner/task/problem.hpp"

namespace pizarra::planner {

// Facts that no operator changes are checked and left out, and so is what cannot be reached even if nothing were ever
// deleted; goals always stay. Failures: bad-task (what is wrong with an operator or a fact), unknown-object,
// unknown-predicate (both name the nearest), too-large, cancelled.
Result<Problem> ground(
    const PlanningTask& task, const std::function<bool()>& cancelled = [] { return false; });

}  // namespace pizarra::planner
