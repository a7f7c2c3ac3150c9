#pragma once

// Planning tasks from files, in PDDL or the thesis' language: see lisp/forms/planning_files.hpp for what is understood.
//
//   const Result<PlanningTask> task = read_task_files("domain.pddl", "problem.pddl");
//   const Result<Problem> problem = ground(*task);

#include "agents/planner/task/planning_task.hpp"
#include "lisp/forms/planning_files.hpp"

namespace pizarra::planner {

Result<PlanningTask> read_task(const Source& domain, const Source& problem);
Result<PlanningTask> read_task_files(const std::string& domain_path, const std::string& problem_path);

}  // namespace pizarra::planner
