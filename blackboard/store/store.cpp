#include "blackboard/store/store.hpp"

#include "blackboard/limits.hpp"
#include "blackboard/store/evaluate.hpp"
#include "blackboard/store/looking.hpp"
#include "blackboard/store/query_tables.hpp"
#include "blackboard/store/transaction_change.hpp"
#include "blackboard/store/transaction_check.hpp"

namespace pizarra::store {

namespace {

constexpr Duration longest_lease = std::chrono::hours(24 * 365);

}  // namespace

Result<std::vector<Relation>> Store::declare(const std::vector<Relation>& relations) {
  std::vector<Relation> fresh;
  for (const Relation& relation : relations) {
    // Through its form, so that one put together in C++ is checked like one that was read.
    const Result<Relation> checked = relation_from_datum(relation_to_datum(relation));
    if (!checked) return fail(checked);
    const auto standing = kept_.tables().find(relation.name);
    if (standing == kept_.tables().end()) {
      fresh.push_back(*checked);
    } else if (standing->second.relation() != *checked) {
      return fail("wrong-shape", "the relation " + relation.name + " is declared differently already",
                  relation_to_datum(standing->second.relation()));
    }
  }
  if (kept_.tables().size() + fresh.size() > limits::relations)
    return fail("too-large", "the board has too many relations");
  for (const Relation& relation : fresh) {
    kept_.tables().try_emplace(relation.name, relation).first->second.forget_removals(kept_.horizon());
  }
  return fresh;
}

Result<Revision> Store::transact(const std::string& teller, const Transaction& transaction, Time now,
                                 std::size_t& examined) {
  const Result<void> checked = TransactionCheck(kept_, teller, transaction, examined).all();
  if (!checked) return fail(checked);
  // As it was looked at, it is done.
  const Indexing no_more(Indexing::May::not_make);
  TransactionChange change(kept_, teller, now);
  change.expect(transaction.steps.size());
  for (const Transaction::Step& step : transaction.steps) {
    if (const auto* tell = std::get_if<Transaction::Tell>(&step)) change.tell(tell->fact, tell->because, tell->lease);
    if (const auto* retract = std::get_if<Transaction::Retract>(&step)) change.retract_matching(retract->pattern);
    if (const auto* settle = std::get_if<Transaction::Settle>(&step)) change.settle(settle->taken);
  }
  return change.finish();
}

Result<Answers> Store::ask(const Query& query, std::size_t& examined) const {
  if (query.at) return fail("no-history", "this board keeps no journal that could say what was");
  const Result<void> checked = check_query_on(query, kept_.tables());
  if (!checked) return fail(checked);
  Result<std::vector<Answer>> answers = evaluate(query, kept_.tables(), examined);
  if (!answers) return fail(answers);
  return Answers{kept_.revision(), std::move(*answers)};
}

Result<std::optional<Fact>> Store::take(const std::string& teller, const Datum& pattern, LeaseId holder, Time now,
                                        std::size_t& examined) {
  const Result<void> light = check_weight(pizarra::weigh(pattern), "the pattern");
  if (!light) return fail(light);
  const Result<const FactTable*> table = table_for(pattern, kept_.tables());
  if (!table) return fail(table);
  const Result<void> allowed = TransactionCheck::teller(teller, (*table)->relation());
  if (!allowed) return fail(allowed);
  if (holder != 0 && kept_.leases().find(holder) == nullptr) return unknown_lease(holder);
  const Fact* fact = kept_.first_standing(**table, pattern, examined);
  const Result<void> cheap = check_looking(examined, pattern);
  if (!cheap) return fail(cheap);
  if (fact == nullptr) return std::nullopt;
  TransactionChange change(kept_, teller, now);
  Fact taken = change.take(fact->id, holder);
  change.finish();
  return taken;
}

const Fact* Store::held(FactId id) const {
  const auto found = kept_.held().find(id);
  return found == kept_.held().end() ? nullptr : &found->second.fact;
}

const Fact* Store::fact(FactId id) const {
  const StandingFact* standing = kept_.find(id);
  return standing == nullptr ? held(id) : &standing->fact;
}

Result<LeaseId> Store::lease(Duration length, Time now) {
  if (length <= Duration::zero() || length > longest_lease) {
    return fail("wrong-shape", "a lease is longer than 0 and at most a year", to_datum(length.count()));
  }
  if (kept_.leases().size() >= limits::leases) return fail("too-large", "the board has too many leases");
  return kept_.leases().grant(length, now);
}

Result<void> Store::renew(LeaseId lease, Time now) {
  if (kept_.leases().find(lease) == nullptr) return unknown_lease(lease);
  kept_.leases().renew(lease, now);
  return {};
}

std::vector<std::pair<Fact, bool>> Store::taken() const {
  std::vector<std::pair<Fact, bool>> all;
  for (const auto& [id, held] : kept_.held()) all.emplace_back(held.fact, held.told_under != 0);
  return all;
}

}  // namespace pizarra::store
