#include "tests/programs/board_tap.hpp"

namespace pizarra::programs {

void BoardTap::note(const Query& query) {
  for (const Query::Clause& clause : query.clauses) {
    if (clause.kind != Query::Clause::Kind::compare) read.emplace(clause.form.head());
  }
}

Task<Result<Revision>> BoardTap::transact(Transaction transaction) {
  for (const Transaction::Precondition& precondition : transaction.preconditions) {
    std::visit([this](const auto& of) { read.emplace(of.pattern.head()); }, precondition);
  }
  for (const Transaction::Step& step : transaction.steps) {
    if (const auto* tell = std::get_if<Transaction::Tell>(&step)) told.emplace(tell->fact.head());
  }
  return board_->transact(std::move(transaction));
}

Task<Result<Answers>> BoardTap::ask(Query query) {
  note(query);
  return board_->ask(std::move(query));
}

Task<Result<std::unique_ptr<Watch>>> BoardTap::watch(Query query) {
  note(query);
  return board_->watch(std::move(query));
}

Task<Result<std::optional<Fact>>> BoardTap::take(Datum pattern, LeaseId holder) {
  read.emplace(pattern.head());
  return board_->take(std::move(pattern), holder);
}

}  // namespace pizarra::programs
