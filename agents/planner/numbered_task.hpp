#pragma once

// The first half of grounding: a planning task with numbers for its names. Operators, initial facts and goals become
// templates over predicates and objects, checked against each other on the way.
//
//   const Result<NumberedTask> numbered = number_task(task);

#include <map>

#include "agents/planner/problem.hpp"

namespace pizarra {

// An atom of an operator: its arguments are parameters (index) or objects (index behind the parameters).
struct AtomTemplate {
  std::size_t predicate = 0;
  std::vector<std::size_t> terms;
  std::size_t last_parameter = 0;  // 1 + the highest parameter it mentions, 0: none
};

struct OperatorTemplate {
  const PlanningOperator* source = nullptr;
  std::vector<std::vector<std::size_t>> candidates;  // of every parameter: the objects of its type
  std::vector<AtomTemplate> preconditions, adds, deletes;
};

struct NumberedPredicate {
  std::string name;
  std::size_t arity = 0;
  bool changes = false;  // some operator adds or deletes it
};

struct NumberedTask {
  std::map<Datum, std::size_t> objects;
  std::vector<NumberedPredicate> predicates;
  std::vector<OperatorTemplate> operators;
  std::vector<AtomTemplate> initials, goals;
};

// Failures: those of ground(). The task outlives the result.
Result<NumberedTask> number_task(const PlanningTask& task);

}  // namespace pizarra
