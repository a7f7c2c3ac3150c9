#pragma once

// The transformation between what the planner is told and what it plans with.
//
//   Result<PlanningOperator> op = operator_from_form(read_one(
//       "(operator PUT-DOWN (params (<ob1> OBJECT)) (preconds (holding <ob1>)) (effects (clear <ob1>) ...))").value());

#include "agents/planner/task/problem.hpp"

namespace pizarra::planner {

// The thesis' syntax; a delete effect is `(del FACT)` or, as Graphplan's own files have it, `(del PREDICATE ...)`.
// Parameters are `<name>` or `?name`. Failure: bad-operator, with the part that is wrong as the subject.
Result<PlanningOperator> operator_from_form(const Datum& form);

// The arguments of get-operations and get-facts. Failures: bad-operator, bad-facts; both with the subject.
Result<std::vector<PlanningOperator>> operators_from_list(const Datum& operators);
struct PlanningFacts {
  std::vector<PlanningObject> objects;  // (types (circle OBJECT) ...)
  std::vector<Datum> initials;          // (initials FACT ...)
  std::vector<Datum> goals;             // (goals FORM ...), at least one; goal_formula.hpp
};
Result<void> check_goal_form(const Datum& form);
Result<PlanningFacts> facts_from_forms(const Datum& types, const Datum& initials, const Datum& goals);

// ((OPERATION ...) ...), and the operations alone, one after another.
Datum steps_to_datum(const PlanSteps& steps);
std::vector<Datum> operations_of(const PlanSteps& steps);

// The failure with `<ob1>` in its subject where the planner has `?ob1`: a fact, and so a reply, holds no variables.
Failure as_asked(Failure failure);

}  // namespace pizarra::planner
