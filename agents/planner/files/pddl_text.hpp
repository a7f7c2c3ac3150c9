#pragma once

// A planning task as PDDL, for programs that read nothing else.
//
//   const PddlText text = pddl_text(task);
//   text.domain;                        // (define (domain pizarra) ...
//   text.objects.find("circle-2");      // what the task calls it: Circle, where there is a circle too
//
// PDDL knows no case, no strings and no numbers for names, and its type `object` is every object's: names are changed
// where they must be, and the maps lead back.

#include "agents/planner/task/planning_task.hpp"

namespace pizarra::planner {

struct PddlText {
  std::string domain;
  std::string problem;
  std::map<std::string, Datum> operators, objects;  // by their names in it
};

PddlText pddl_text(const PlanningTask& task);

}  // namespace pizarra::planner
