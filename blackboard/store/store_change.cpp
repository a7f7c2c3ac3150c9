#include "blackboard/store/store_change.hpp"

#include <algorithm>

#include "lisp/pattern.hpp"

namespace pizarra::store {

using Kind = Commit::Entry::Kind;

Store::Change::Change(Store& store, std::string teller, Time now) : store_(store), first_own_(store.next_fact_) {
  commit_.revision = store.revision_ + 1;
  commit_.when = now;
  commit_.teller = std::move(teller);
}

// Most transactions are about one relation.
FactTable& Store::Change::table_of(const Datum& fact) {
  if (last_table_ == nullptr || last_table_->relation().name != fact.head()) {
    last_table_ = &store_.tables_.find(fact.head())->second;
  }
  return *last_table_;
}

void Store::Change::tell(const Datum& fact, const std::vector<FactId>& because, LeaseId lease) {
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

void Store::Change::note_own(Commit::Entry entry) {
  entries_of_own_.push_back(commit_.entries.size());
  commit_.entries.push_back(std::move(entry));
}

Fact Store::Change::fresh(const Datum& fact, const std::vector<FactId>& because) {
  return {.datum = fact,
          .id = store_.next_fact_++,
          .teller = commit_.teller,
          .when = commit_.when,
          .revision = commit_.revision,
          .because = because};
}

void Store::Change::replace(StandingFact& standing, Fact fact, LeaseId lease) {
  FactTable& table = *standing.table;
  let_go_of_leases(standing);
  commit_.entries.emplace_back(Kind::retracted, store_.replace(standing, std::move(fact)));
  note_own({.kind = Kind::told, .fact = standing.fact, .under_lease = lease != 0 && table.relation().durable});
  set_lease(table, standing, lease);
}

void Store::Change::retract(FactId id) {
  Fact fact = remove(*store_.find(id));
  if (fact.revision == commit_.revision) {
    entry_of(id).fact.id = 0;
  } else {
    commit_.entries.emplace_back(Kind::retracted, std::move(fact));
  }
}

void Store::Change::retract_matching(const Datum& pattern) {
  std::vector<FactId> fitting;
  table_of(pattern).visit(pattern, [&](const Fact& fact) {
    Bindings bindings;
    if (match(pattern, fact.datum, bindings)) fitting.push_back(fact.id);
    return true;
  });
  for (const FactId id : fitting) retract(id);
}

Fact Store::Change::take(FactId id, LeaseId holder) {
  StandingFact& standing = *store_.find(id);
  const LeaseId told_under = standing.lease;
  Fact fact = remove(standing);
  commit_.entries.push_back({holder == 0 ? Kind::retracted : Kind::taken, fact});
  if (holder != 0) {
    store_.hold({fact, holder, told_under});
    store_.leases_.find(holder)->held.insert(id);
  }
  return fact;
}

void Store::Change::settle(FactId taken) {
  Held held = store_.let_go(taken);
  if (Leases::Lease* lease = store_.leases_.find(held.holder)) lease->held.erase(taken);
  commit_.entries.push_back({Kind::settled, std::move(held.fact)});
}

void Store::Change::put_back(FactId taken) {
  const auto held = store_.held_.find(taken);
  FactTable& table = table_of(held->second.fact.datum);
  const LeaseId lease = held->second.told_under;
  const bool lapsed = lease != 0 && !store_.leases_.contains(lease);
  const StandingFact* in_its_place = table.find_key_of(held->second.fact.datum);
  const bool is_free = in_its_place == nullptr || store_.is_to_go(in_its_place->fact.id);
  if (lapsed || !is_free) return settle(taken);
  if (in_its_place != nullptr) retract(in_its_place->fact.id);
  Fact fact = store_.let_go(taken).fact;
  fact.id = store_.next_fact_++;
  fact.revision = commit_.revision;
  note_own({Kind::returned, fact, taken, lease != 0 && table.relation().durable});
  insert(std::move(fact), lease);
}

Revision Store::Change::finish() {
  std::erase_if(commit_.entries, [](const Commit::Entry& entry) { return entry.fact.id == 0; });
  if (commit_.entries.empty()) return store_.revision_;
  store_.revision_ = commit_.revision;
  if (store_.on_commit) store_.on_commit(commit_);
  return store_.revision_;
}

Fact Store::Change::remove(StandingFact& standing) {
  let_go_of_leases(standing);
  return store_.remove(standing, commit_.revision).fact;
}

void Store::Change::let_go_of_leases(StandingFact& standing) {
  const FactId id = standing.fact.id;
  if (standing.lease != 0) {
    if (Leases::Lease* lease = store_.leases_.find(standing.lease)) lease->facts.erase(id);
  }
  if (standing.expiry) store_.fact_expiries_.erase({*standing.expiry, id});
  standing.lease = 0;
  standing.expiry.reset();
}

void Store::Change::insert(Fact fact, LeaseId lease) {
  FactTable& table = table_of(fact.datum);
  set_lease(table, store_.put(table, std::move(fact)), lease);
}

// Whether a durable fact goes with a lease is part of what must last: it is not to outlive a lease that did not.
void Store::Change::note_lease(const FactTable& table, const StandingFact& standing, LeaseId lease) {
  const bool changes = (standing.lease != 0) != (lease != 0);
  if (!table.relation().durable || !changes) return;
  if (standing.fact.revision != commit_.revision) {
    commit_.entries.emplace_back(lease != 0 ? Kind::leased : Kind::kept, standing.fact);
    return;
  }
  entry_of(standing.fact.id).under_lease = lease != 0;
}

void Store::Change::set_lease(FactTable& table, StandingFact& standing, LeaseId lease) {
  const FactId id = standing.fact.id;
  if (standing.lease != lease) {
    Leases::Lease* former = standing.lease == 0 ? nullptr : store_.leases_.find(standing.lease);
    Leases::Lease* now = lease == 0 ? nullptr : store_.leases_.find(lease);
    if (former != nullptr) former->facts.erase(id);
    if (now != nullptr) now->facts.insert(id);
    standing.lease = lease;
  }
  if (standing.expiry) store_.fact_expiries_.erase({*standing.expiry, id});
  if (!table.relation().lease) return;
  standing.expiry = commit_.when + *table.relation().lease;
  store_.fact_expiries_.emplace(*standing.expiry, id);
}

}  // namespace pizarra::store
