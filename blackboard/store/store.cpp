#include "blackboard/store/store.hpp"

#include "blackboard/limits.hpp"
#include "blackboard/store/capacity.hpp"
#include "blackboard/store/evaluate.hpp"
#include "blackboard/store/fitting.hpp"
#include "blackboard/store/looking.hpp"
#include "blackboard/store/query_tables.hpp"
#include "blackboard/store/store_change.hpp"
#include "blackboard/store/store_check.hpp"

namespace pizarra::store {

namespace {

constexpr Duration longest_lease = std::chrono::hours(24 * 365);

}  // namespace

std::unexpected<Failure> Store::unknown_lease(LeaseId lease) {
  return fail("unknown-lease", "lease " + std::to_string(lease) + " has lapsed, or never was", to_datum(lease));
}

Result<std::vector<Relation>> Store::declare(const std::vector<Relation>& relations) {
  std::vector<Relation> fresh;
  for (const Relation& relation : relations) {
    // Through its form, so that one put together in C++ is checked like one that was read.
    const Result<Relation> checked = relation_from_datum(relation_to_datum(relation));
    if (!checked) return fail(checked);
    const auto standing = tables_.find(relation.name);
    if (standing == tables_.end()) {
      fresh.push_back(*checked);
    } else if (standing->second.relation() != *checked) {
      return fail("wrong-shape", "the relation " + relation.name + " is declared differently already",
                  relation_to_datum(standing->second.relation()));
    }
  }
  if (tables_.size() + fresh.size() > limits::relations) return fail("too-large", "the board has too many relations");
  for (const Relation& relation : fresh) {
    tables_.try_emplace(relation.name, relation).first->second.forget_removals(horizon_);
  }
  return fresh;
}

Result<Revision> Store::transact(const std::string& teller, const Transaction& transaction, Time now,
                                 std::size_t& examined) {
  const Result<void> checked = Check(*this, teller, transaction, examined).all();
  if (!checked) return fail(checked);
  // As it was looked at, it is done.
  const Indexing no_more(Indexing::May::not_make);
  Change change(*this, teller, now);
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
  const Result<void> checked = check_query_on(query, tables_);
  if (!checked) return fail(checked);
  Result<std::vector<Answer>> answers = evaluate(query, tables_, examined);
  if (!answers) return fail(answers);
  return Answers{revision_, std::move(*answers)};
}

Result<std::optional<Fact>> Store::take(const std::string& teller, const Datum& pattern, LeaseId holder, Time now,
                                        std::size_t& examined) {
  const Result<void> light = check_weight(pizarra::weigh(pattern), "the pattern");
  if (!light) return fail(light);
  const Result<const FactTable*> table = table_for(pattern, tables_);
  if (!table) return fail(table);
  const Result<void> allowed = Check::teller(teller, (*table)->relation());
  if (!allowed) return fail(allowed);
  if (holder != 0 && leases_.find(holder) == nullptr) return unknown_lease(holder);
  const Fact* fact = first_standing(**table, pattern, examined);
  const Result<void> cheap = check_looking(examined, pattern);
  if (!cheap) return fail(cheap);
  if (fact == nullptr) return std::nullopt;
  Change change(*this, teller, now);
  Fact taken = change.take(fact->id, holder);
  change.finish();
  return taken;
}

// While nothing lapses, all that is there stands.
const Fact* Store::first_standing(const FactTable& table, const Datum& pattern, std::size_t& examined) const {
  if (lapsing_.empty()) return first_fit(table, pattern, examined);
  return first_fit(table, pattern, examined, [this](const Fact& fact) { return !is_to_go(fact.id); });
}

bool Store::is_to_go(FactId standing) const {
  const LeaseId lease = lease_of(standing);
  return lease != 0 && !leases_.contains(lease);
}

const Fact* Store::held(FactId id) const {
  const auto found = held_.find(id);
  return found == held_.end() ? nullptr : &found->second.fact;
}

const Fact* Store::fact(FactId id) const {
  const StandingFact* standing = find(id);
  return standing == nullptr ? held(id) : &standing->fact;
}

Result<LeaseId> Store::lease(Duration length, Time now) {
  if (length <= Duration::zero() || length > longest_lease) {
    return fail("wrong-shape", "a lease is longer than 0 and at most a year", to_datum(length.count()));
  }
  if (leases_.size() >= limits::leases) return fail("too-large", "the board has too many leases");
  return leases_.grant(length, now);
}

Result<void> Store::renew(LeaseId lease, Time now) {
  if (leases_.find(lease) == nullptr) return unknown_lease(lease);
  leases_.renew(lease, now);
  return {};
}

LeaseId Store::lease_of(FactId standing) const {
  const StandingFact* found = find(standing);
  return found == nullptr ? 0 : found->lease;
}

StandingFact* Store::find(FactId standing) const {
  return standing_.find(standing, [](const StandingFact&) { return true; });
}

StandingFact& Store::put(FactTable& table, Fact fact) {
  const std::size_t before = table.bytes();
  StandingFact& standing = table.insert({std::move(fact)});
  bytes_ += table.bytes() - before;
  standing_.insert(standing.fact.id, &standing);
  return standing;
}

Fact Store::replace(StandingFact& standing, Fact fact) {
  standing_.erase(standing.fact.id, &standing);
  standing_.insert(fact.id, &standing);
  const std::size_t before = standing.table->bytes();
  Fact former = standing.table->replace(standing, std::move(fact));
  bytes_ += standing.table->bytes() - before;
  return former;
}

StandingFact Store::remove(StandingFact& standing, Revision revision) {
  standing_.erase(standing.fact.id, &standing);
  FactTable& table = *standing.table;
  const std::size_t before = table.bytes();
  StandingFact gone = table.remove(standing, revision);
  bytes_ -= before - table.bytes();
  return gone;
}

void Store::hold(Held held) {
  bytes_ += footprint(held.fact);
  const FactId id = held.fact.id;
  held_[id] = std::move(held);
}

Store::Held Store::let_go(FactId taken) {
  Held held = std::move(held_.extract(taken).mapped());
  bytes_ -= footprint(held.fact);
  return held;
}

LeaseId Store::holder_of(FactId taken) const {
  const auto held = held_.find(taken);
  return held == held_.end() ? 0 : held->second.holder;
}

}  // namespace pizarra::store
