#include "agents/vision/agent/fact_teller.hpp"

namespace pizarra::vision {

void FactTeller::begin_anew() {
  // What was told under another presence went with it.
  if (lost()) ++beginnings_;
  told_under_ = presence();
}

Task<void> FactTeller::transact(Transaction transaction) {
  if (transaction.steps.empty()) co_return;
  const Result<Revision> told = co_await context_.board.transact(std::move(transaction));
  if (!told) told_under_ = 0;
}

void FactTeller::add(Transaction& transaction, const std::vector<Datum>& facts) const {
  for (const Datum& fact : facts) transaction.tell(told_by(context_.name, fact), {}, presence());
}

void FactTeller::retract_all(Transaction& transaction, Datum relation, std::size_t arguments) const {
  transaction.retract(any_told_by(context_.name, std::move(relation), arguments));
}

void FactTeller::retract(Transaction& transaction, const Datum& fact) const {
  transaction.retract(told_by(context_.name, fact));
}

Task<Result<std::vector<Fact>>> FactTeller::standing(Datum relation, std::size_t arguments) {
  return context_.board.facts(any_told_by(context_.name, std::move(relation), arguments));
}

Task<void> FactTeller::tell(std::vector<Datum> facts) {
  Transaction transaction;
  add(transaction, facts);
  co_await transact(std::move(transaction));
}

}  // namespace pizarra::vision
