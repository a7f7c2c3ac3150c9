#include "blackboard/delta.hpp"

#include <algorithm>

namespace pizarra {

std::size_t width_of(const Query& query) {
  return static_cast<std::size_t>(std::ranges::count(query.clauses, Query::Clause::Kind::fact, &Query::Clause::kind));
}

Answering::Answering(const Query& query) {
  for (const Query::Clause& clause : query.clauses) {
    if (clause.kind == Query::Clause::Kind::fact) patterns_.push_back(clause.form);
  }
  if (patterns_.size() == 1) only_ = FlatPattern::of(patterns_.front());
}

Result<std::vector<Answer>> Answering::answers(Delta::Side side) const {
  std::vector<Answer> answers(side.answers);
  auto next = side.facts.begin();
  for (Answer& answer : answers) {
    answer.facts.reserve(patterns_.size());
    for (std::size_t pattern = 0; pattern < patterns_.size(); ++pattern) {
      if (!match_next(pattern, next->datum, answer.bindings)) {
        return fail("bad-frame", "a fact does not fit the query", next->datum);
      }
      answer.facts.push_back(std::move(*next++));
    }
  }
  return answers;
}

bool Answering::match_next(std::size_t pattern, const Datum& datum, Bindings& bindings) const {
  if (!only_) return match(patterns_[pattern], datum, bindings);
  std::optional<Bindings> found = only_->match(datum);
  if (!found) return false;
  bindings = std::move(*found);
  return true;
}

Result<Change> Answering::change(Delta delta) const {
  Result<std::vector<Answer>> added = answers(std::move(delta.added));
  if (!added) return fail(added);
  Result<std::vector<Answer>> removed = answers(std::move(delta.removed));
  if (!removed) return fail(removed);
  return Change{delta.revision, delta.kind != Delta::Kind::change, std::move(*added), std::move(*removed)};
}

}  // namespace pizarra
