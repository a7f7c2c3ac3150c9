#pragma once

// How people wrote what a task holds: `<x>` in the thesis' files and `?x` in PDDL are the same parameter, for which the
// task has `?x`.
//
//   written(task, read_one("(holding ?x)").value());      // (holding <x>), where the task is the thesis'

#include "agents/planner/task/planning_task.hpp"

namespace pizarra::planner {

// `<x>` in the place of `?x`, everywhere in the datum.
Datum with_angles(const Datum& datum);

std::string written(const PlanningTask& task, const Datum& datum);

}  // namespace pizarra::planner
