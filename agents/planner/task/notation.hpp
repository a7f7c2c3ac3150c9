#pragma once

// How people wrote what a task holds: `<x>` in the thesis' files and `?x` in PDDL are the same parameter, for which the
// task has `?x`.
//
//   written(task, read_one("(holding ?x)").value());      // (holding <x>), where the task is the thesis'

#include "agents/planner/task/planning_task.hpp"
#include "lisp/forms/goal_formula.hpp"
#include "lisp/writer.hpp"

namespace pizarra::planner {

inline std::string written(const PlanningTask& task, const Datum& datum) {
  return write(task.angles ? forms::without_variables(datum) : datum);
}

}  // namespace pizarra::planner
