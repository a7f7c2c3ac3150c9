#include "blackboard/delta.hpp"

#include <algorithm>

#include "lisp/pattern.hpp"

namespace pizarra {

std::size_t width_of(const Query& query) {
  return static_cast<std::size_t>(std::ranges::count(query.clauses, Query::Clause::Kind::fact, &Query::Clause::kind));
}

std::vector<Answer> answers_of(const Query& query, Delta::Side side) {
  std::vector<Answer> answers(side.answers);
  auto next = side.facts.begin();
  for (Answer& answer : answers) {
    for (const Query::Clause& clause : query.clauses) {
      if (clause.kind != Query::Clause::Kind::fact) continue;
      match(clause.form, next->datum, answer.bindings);
      answer.facts.push_back(std::move(*next++));
    }
  }
  return answers;
}

}  // namespace pizarra
