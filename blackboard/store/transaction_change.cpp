#include "blackboard/store/transaction_change.hpp"

#include <algorithm>

#include "lisp/pattern.hpp"

namespace pizarra::store {

using Kind = Commit::Entry::Kind;

TransactionChange::TransactionChange(KeptFacts& kept, std::string teller, Time now)
    : kept_(kept), first_own_(kept.next_id()) {
  commit_.revision = kept.revision() + 1;
  commit_.when = now;
  commit_.teller = std::move(teller);
}

// Most transactions are about one relation.
FactTable& TransactionChange::table_of(const Datum& fact) {
  if (last_table_ == nullptr || last_table_->relation().name != fact.head()) {
    last_table_ = &kept_.tables().find(fact.head())->second;
  }
  return *last_table_;
}

void TransactionChange::tell(const Datum& fact, const std::vector<FactId>& because, LeaseId lease) {
  FactTable& table = table_of(fact);
  if (StandingFact* standing = table.find_key_of(fact)) {
    if (standing->fact.datum == fact) {
      note_lease(table, *standing, lease);
      return set_lease(table, *standing, lease);
    }
    if (standing->fact.revision != commit_.revision) return replace(*standing, fresh(fact, because), lease);
    retract(standing->fact.id);
  }
  Fact told = fresh(fact, because);
  note_own({.kind = Kind::told, .fact = told, .under_lease = lease != 0 && table.relation().durable});
  insert(std::move(told), lease);
}

void TransactionChange::note_own(Commit::Entry entry) {
  entries_of_own_.push_back(commit_.entries.size());
  commit_.entries.push_back(std::move(entry));
}

Fact TransactionChange::fresh(const Datum& fact, const std::vector<FactId>& because) {
  return {.datum = fact,
          .id = kept_.take_id(),
          .teller = commit_.teller,
          .when = commit_.when,
          .revision = commit_.revision,
          .because = because};
}

void TransactionChange::replace(StandingFact& standing, Fact fact, LeaseId lease) {
  FactTable& table = *standing.table;
  let_go_of_leases(standing);
  commit_.entries.emplace_back(Kind::retracted, kept_.replace(standing, std::move(fact)));
  note_own({.kind = Kind::told, .fact = standing.fact, .under_lease = lease != 0 && table.relation().durable});
  set_lease(table, standing, lease);
}

void TransactionChange::retract(FactId id) {
  Fact fact = remove(*kept_.find(id));
  if (fact.revision == commit_.revision) {
    entry_of(id).fact.id = 0;
  } else {
    commit_.entries.emplace_back(Kind::retracted, std::move(fact));
  }
}

void TransactionChange::retract_matching(const Datum& pattern) {
  std::vector<FactId> fitting;
  table_of(pattern).visit(pattern, [&](const Fact& fact) {
    Bindings bindings;
    if (match(pattern, fact.datum, bindings)) fitting.push_back(fact.id);
    return true;
  });
  for (const FactId id : fitting) retract(id);
}

Fact TransactionChange::take(FactId id, LeaseId holder) {
  StandingFact& standing = *kept_.find(id);
  const LeaseId told_under = standing.lease;
  Fact fact = remove(standing);
  commit_.entries.push_back({holder == 0 ? Kind::retracted : Kind::taken, fact});
  if (holder != 0) {
    kept_.hold({fact, holder, told_under});
    kept_.leases().find(holder)->held.insert(id);
  }
  return fact;
}

void TransactionChange::settle(FactId taken) {
  KeptFacts::Held held = kept_.let_go(taken);
  if (Leases::Lease* lease = kept_.leases().find(held.holder)) lease->held.erase(taken);
  commit_.entries.push_back({Kind::settled, std::move(held.fact)});
}

void TransactionChange::put_back(FactId taken) {
  const auto held = kept_.held().find(taken);
  FactTable& table = table_of(held->second.fact.datum);
  const LeaseId lease = held->second.told_under;
  const bool lapsed = lease != 0 && !kept_.leases().contains(lease);
  const StandingFact* in_its_place = table.find_key_of(held->second.fact.datum);
  const bool is_free = in_its_place == nullptr || kept_.is_to_go(in_its_place->fact.id);
  if (lapsed || !is_free) return settle(taken);
  if (in_its_place != nullptr) retract(in_its_place->fact.id);
  Fact fact = kept_.let_go(taken).fact;
  fact.id = kept_.take_id();
  fact.revision = commit_.revision;
  note_own({Kind::returned, fact, taken, lease != 0 && table.relation().durable});
  insert(std::move(fact), lease);
}

Revision TransactionChange::finish() {
  std::erase_if(commit_.entries, [](const Commit::Entry& entry) { return entry.fact.id == 0; });
  if (commit_.entries.empty()) return kept_.revision();
  kept_.commit(commit_);
  return kept_.revision();
}

Fact TransactionChange::remove(StandingFact& standing) {
  let_go_of_leases(standing);
  return kept_.remove(standing, commit_.revision).fact;
}

void TransactionChange::let_go_of_leases(StandingFact& standing) {
  const FactId id = standing.fact.id;
  if (standing.lease != 0) {
    if (Leases::Lease* lease = kept_.leases().find(standing.lease)) lease->facts.erase(id);
  }
  if (standing.expiry) kept_.expiries().erase({*standing.expiry, id});
  standing.lease = 0;
  standing.expiry.reset();
}

void TransactionChange::insert(Fact fact, LeaseId lease) {
  FactTable& table = table_of(fact.datum);
  set_lease(table, kept_.put(table, std::move(fact)), lease);
}

// Whether a durable fact goes with a lease is part of what must last: it is not to outlive a lease that did not.
void TransactionChange::note_lease(const FactTable& table, const StandingFact& standing, LeaseId lease) {
  const bool changes = (standing.lease != 0) != (lease != 0);
  if (!table.relation().durable || !changes) return;
  if (standing.fact.revision != commit_.revision) {
    commit_.entries.emplace_back(lease != 0 ? Kind::leased : Kind::kept, standing.fact);
    return;
  }
  entry_of(standing.fact.id).under_lease = lease != 0;
}

void TransactionChange::set_lease(FactTable& table, StandingFact& standing, LeaseId lease) {
  const FactId id = standing.fact.id;
  if (standing.lease != lease) {
    Leases::Lease* former = standing.lease == 0 ? nullptr : kept_.leases().find(standing.lease);
    Leases::Lease* now = lease == 0 ? nullptr : kept_.leases().find(lease);
    if (former != nullptr) former->facts.erase(id);
    if (now != nullptr) now->facts.insert(id);
    standing.lease = lease;
  }
  if (standing.expiry) kept_.expiries().erase({*standing.expiry, id});
  if (!table.relation().lease) return;
  standing.expiry = commit_.when + *table.relation().lease;
  kept_.expiries().emplace(*standing.expiry, id);
}

}  // namespace pizarra::store
