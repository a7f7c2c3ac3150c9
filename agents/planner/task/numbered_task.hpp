#pragma once

// The first half of grounding: a planning task with numbers for its names. Operators, initial facts and goals become
// templates over predicates and objects, checked against each other on the way.
//
//   const Result<NumberedTask> numbered = number_task(task);

#include <map>

#include "agents/planner/task/problem.hpp"

namespace pizarra::planner {

constexpr std::size_t no_predicate = static_cast<std::size_t>(-1);

// An atom of an operator: its arguments are parameters (index) or objects (index behind the parameters).
struct AtomTemplate {
  std::size_t predicate = 0;
  std::vector<std::size_t> terms;
  std::size_t last_parameter = 0;  // 1 + the highest parameter it mentions, 0: none
};

struct EqualityTemplate {
  std::size_t left = 0, right = 0;  // as the terms of an atom
  std::size_t last_parameter = 0;
  bool equal = true;
};

struct OperatorTemplate {
  const PlanningOperator* source = nullptr;
  std::vector<std::vector<std::size_t>> candidates;  // of every parameter: the objects of its type
  std::vector<AtomTemplate> preconditions, absents, adds, deletes;
  std::vector<EqualityTemplate> equalities;
  std::vector<AtomTemplate> costs;  // functions
  std::int64_t fixed_cost = 0;
};

struct NumberedPredicate {
  std::string name;
  std::size_t arity = 0;
  bool changes = false;  // some operator adds or deletes it
  // Another predicate that holds where this one does not, if some condition asks for that.
  std::size_t complement = no_predicate;
  bool is_complement = false;
};

struct NumberedTask {
  std::map<Datum, std::size_t> objects;
  std::vector<NumberedPredicate> predicates;  // and functions
  std::vector<OperatorTemplate> operators;
  std::vector<AtomTemplate> initials, goals;  // absent goals are goals of the complement
  std::vector<std::pair<AtomTemplate, std::int64_t>> values;
};

// Failures: those of ground(). The task outlives the result.
Result<NumberedTask> number_task(const PlanningTask& task);

}  // namespace pizarra::planner
