#pragma once

// What is to be planned, as people and other agents say it: operators with ?variables, typed objects, the facts that
// hold and the facts that are wanted. STRIPS: no negative preconditions; what an action both deletes and adds, holds
// afterwards; two parameters may stand for the same object unless the preconditions prevent it.
//
//   PlanningTask task;
//   task.operators.push_back({"PICK-UP", {{"?x", "OBJECT"}}, {(clear ?x) ...}, {(holding ?x)}, {(clear ?x) ...}});
//   task.objects = {{"circle"_sym, "OBJECT"}};
//   Result<Problem> problem = ground(task);           // grounding.hpp

#include <string>
#include <vector>

#include "lisp/datum.hpp"
#include "lisp/result.hpp"

namespace pizarra {

struct PlanningParameter {
  std::string variable;  // with its question mark
  std::string type;
};

struct PlanningOperator {
  std::string name;
  std::vector<PlanningParameter> parameters;
  std::vector<Datum> preconditions;
  std::vector<Datum> adds;
  std::vector<Datum> deletes;
};

struct PlanningObject {
  Datum name;  // a symbol, a string or a number
  std::string type;
};

struct PlanningTask {
  std::vector<PlanningOperator> operators;
  std::vector<PlanningObject> objects;
  std::vector<Datum> initials;
  std::vector<Datum> goals;
};

// The steps of a plan in the people's terms: every step is a set of operations `(STACK circle triangle)` that do not
// interfere with each other, in a fixed order.
using PlanSteps = std::vector<std::vector<Datum>>;

// Replays the steps fact by fact, independently of any engine and of the grounding. Failures: `bad-plan`, with the
// operation that cannot be done, the two that interfere, or the goal that is not reached as the subject.
Result<void> validate_plan(const PlanningTask& task, const PlanSteps& steps);

}  // namespace pizarra
