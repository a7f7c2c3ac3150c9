#pragma once

// A planning problem as people and other agents write it: operators with ?variables, typed objects, the facts that hold
// and the facts that are wanted. STRIPS with absent facts, equalities and costs: what an action both deletes and adds,
// holds afterwards; two parameters may stand for the same object unless the preconditions prevent it.
//
//   PlanningTask task;
//   task.operators.push_back({"PICK-UP", {{"?x", "OBJECT"}}, {(clear ?x) ...}, {(holding ?x)}, {(clear ?x) ...}});
//   task.objects = {{"circle"_sym, "OBJECT"}};
//   Result<Problem> problem = ground(task);           // problem.hpp
//
// From files: agents/planner/files/task_files.hpp.

#include <map>
#include <set>
#include <string>
#include <vector>

#include "lisp/datum.hpp"
#include "lisp/result.hpp"

namespace pizarra::planner {

struct PlanningParameter {
  std::string variable;  // with its question mark
  std::string type;
  bool operator==(const PlanningParameter&) const = default;
};

// `(= a b)` or not, between parameters and objects.
struct PlanningEquality {
  Datum left, right;
  bool equal = true;
  bool operator==(const PlanningEquality&) const = default;
};

struct PlanningOperator {
  std::string name;
  std::vector<PlanningParameter> parameters;
  std::vector<Datum> preconditions;
  std::vector<Datum> adds;
  std::vector<Datum> deletes;
  std::vector<Datum> absents = {};  // facts that must not hold
  std::vector<PlanningEquality> equalities = {};
  std::vector<Datum> costs = {};  // summed up: whole numbers, and functions like (distance ?from ?to)
  bool operator==(const PlanningOperator&) const = default;
};

struct PlanningObject {
  Datum name;  // a symbol, a string or a number
  std::string type;
  bool operator==(const PlanningObject&) const = default;
};

// An object of a type is one of its parents too; a type may have several. Types without parents need no mention.
struct PlanningType {
  std::string name;
  std::string parent;
  bool operator==(const PlanningType&) const = default;
};

struct PlanningTask {
  std::vector<PlanningOperator> operators;
  std::vector<PlanningObject> objects;
  std::vector<Datum> initials;
  std::vector<Datum> goals;
  std::vector<Datum> absent_goals = {};  // facts that must not hold in the end
  std::vector<PlanningType> types = {};
  std::map<Datum, std::int64_t> values =
      {};  // (distance paris lyon) to 470; an action whose cost has none is impossible
  // Declared: a goal of any other predicate that no operator and no initial fact speaks of is a slip of the pen.
  std::set<std::string> predicates = {};
  bool counts_cost = false;  // whether a plan is the better the less it costs, else the shorter
  bool angles = false;       // whether people wrote `<x>` for the parameter ?x: notation.hpp
};

// Whether every object of `type` is one of `wanted`.
bool is_subtype(const std::vector<PlanningType>& types, const std::string& type, const std::string& wanted);

// The steps of a plan in the people's terms: every step is a set of operations `(STACK circle triangle)` that do not
// interfere with each other, in a fixed order.
using PlanSteps = std::vector<std::vector<Datum>>;

// Replays the steps fact by fact, independently of any engine and of the grounding. Failures: `bad-plan`, with the
// operation that cannot be done, the two that interfere, or the goal that is not reached as the subject.
Result<void> validate_plan(const PlanningTask& task, const PlanSteps& steps);

// The cost of a valid plan: one for each action where the task counts no cost.
std::int64_t plan_cost(const PlanningTask& task, const PlanSteps& steps);

}  // namespace pizarra::planner
