#include "blackboard/delta.hpp"

#include <algorithm>

#include "lisp/pattern.hpp"

namespace pizarra {

std::size_t width_of(const Query& query) {
  return static_cast<std::size_t>(std::ranges::count(query.clauses, Query::Clause::Kind::fact, &Query::Clause::kind));
}

Result<std::vector<Answer>> answers_of(const Query& query, Delta::Side side) {
  std::vector<Answer> answers(side.answers);
  auto next = side.facts.begin();
  const std::size_t width = width_of(query);
  for (Answer& answer : answers) {
    answer.facts.reserve(width);
    for (const Query::Clause& clause : query.clauses) {
      if (clause.kind != Query::Clause::Kind::fact) continue;
      if (!match(clause.form, next->datum, answer.bindings)) {
        return fail("bad-frame", "a fact does not fit the query", next->datum);
      }
      answer.facts.push_back(std::move(*next++));
    }
  }
  return answers;
}

Result<Change> change_of(const Query& query, Delta delta) {
  Result<std::vector<Answer>> added = answers_of(query, std::move(delta.added));
  if (!added) return fail(added);
  Result<std::vector<Answer>> removed = answers_of(query, std::move(delta.removed));
  if (!removed) return fail(removed);
  return Change{delta.revision, delta.kind != Delta::Kind::change, std::move(*added), std::move(*removed)};
}

}  // namespace pizarra
