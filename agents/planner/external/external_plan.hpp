#pragma once

// A plan from a foreign planner (drivers/pddl_planner/), in the task's own names, and true: it has passed the
// validator.
//
//   const ExternalPlanner planner("ff -o {domain} -f {problem}");
//   const Result<PlanSteps> steps = plan_externally(planner, task, [] { return false; });

#include "agents/planner/task/planning_task.hpp"
#include "drivers/pddl_planner/external_planner.hpp"

namespace pizarra::planner {

// Every step is one action. Failures: the driver's, bad-plan, and those of ground() for a task that makes no sense.
Result<PlanSteps> plan_externally(const pddl_planner::ExternalPlanner& planner, const PlanningTask& task,
                                  const std::function<bool()>& cancelled);

}  // namespace pizarra::planner
