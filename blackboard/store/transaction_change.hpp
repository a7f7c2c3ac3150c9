#pragma once

// One transaction while it is carried out: every change of the kept facts goes through here and becomes part of
// the Commit that finish() hands on. Nothing here can fail; what could was checked before.
//
// Lifecycle: one transaction. The kept facts outlive it. The steps in their order; finish() once.
//
//   TransactionChange change(kept, "vision", now);
//   change.tell(fact, because, lease);
//   const Revision revision = change.finish();

#include "blackboard/store/kept_facts.hpp"

namespace pizarra::store {

class TransactionChange {
 public:
  TransactionChange(KeptFacts& kept, std::string teller, Time now);

  // Makes room for so many steps.
  void expect(std::size_t steps) { commit_.entries.reserve(2 * steps); }
  void tell(const Datum& fact, const std::vector<FactId>& because, LeaseId lease);
  void retract(FactId id);
  void retract_matching(const Datum& pattern);
  Fact take(FactId id, LeaseId holder);
  void settle(FactId taken);
  // Puts a held fact back under a new id and the lease that it was told under. It goes where that has lapsed, or where
  // another with its key stands by now.
  void put_back(FactId taken);
  // The revision that the facts are at then; a new one if anything changed.
  Revision finish();

 private:
  FactTable& table_of(const Datum& fact);
  void note_own(Commit::Entry entry);
  // The commit's words about one of its own facts.
  Commit::Entry& entry_of(FactId own) { return commit_.entries[entries_of_own_[own - first_own_]]; }
  Fact remove(StandingFact& standing);
  Fact fresh(const Datum& fact, const std::vector<FactId>& because);
  void replace(StandingFact& standing, Fact fact, LeaseId lease);
  void insert(Fact fact, LeaseId lease);
  void let_go_of_leases(StandingFact& standing);
  void note_lease(const FactTable& table, const StandingFact& standing, LeaseId lease);
  void set_lease(FactTable& table, StandingFact& entry, LeaseId lease);

  KeptFacts& kept_;
  FactTable* last_table_ = nullptr;
  Commit commit_;
  const FactId first_own_;                   // of the facts that come with this commit
  std::vector<std::size_t> entries_of_own_;  // by their ids; an entry whose fact has none is of one that went again
};

}  // namespace pizarra::store
