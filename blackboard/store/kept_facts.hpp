#pragma once

// The facts that a board keeps: those that stand, each in the table of its relation, those that are taken and may come
// back, and the leases that they go with. Here they are found, put in their places and counted.
// Transactions say what may be done with them (transaction_check.hpp, transaction_change.hpp).
//
//   StandingFact& standing = kept.put(table, fact);
//   kept.remove(standing, revision);

#include <functional>
#include <map>
#include <set>

#include "blackboard/fact.hpp"
#include "blackboard/store/commit.hpp"
#include "blackboard/store/fact_table.hpp"
#include "blackboard/store/index_maker.hpp"
#include "blackboard/store/leases.hpp"

namespace pizarra::store {

class KeptFacts {
 public:
  struct Held {
    Fact fact;
    LeaseId holder;
    LeaseId told_under;  // 0 for none
  };

  explicit KeptFacts(LeaseId first_lease) : leases_(first_lease) {}
  KeptFacts(const KeptFacts&) = delete;
  KeptFacts& operator=(const KeptFacts&) = delete;

  std::function<void(const Commit&)> on_commit;
  // The facts have changed as it says, and are at its revision from here on.
  void commit(const Commit& commit);

  Tables& tables() { return tables_; }
  const Tables& tables() const { return tables_; }
  // The speed at which a fact is found is no part of the board's content.
  IndexMaker& index_maker() const { return index_maker_; }
  Leases& leases() { return leases_; }
  const Leases& leases() const { return leases_; }
  // When leased facts lapse.
  std::set<std::pair<Time, FactId>>& expiries() { return expiries_; }
  const std::set<std::pair<Time, FactId>>& expiries() const { return expiries_; }

  std::size_t size() const { return standing_.size(); }
  std::size_t bytes() const { return bytes_; }  // of what stands or is held
  StandingFact* find(FactId standing) const;
  StandingFact& put(FactTable& table, Fact fact);
  Fact replace(StandingFact& standing, Fact fact);
  StandingFact remove(StandingFact& standing, Revision revision);

  // Those that are taken, by their ids.
  const std::map<FactId, Held>& held() const { return held_; }
  void hold(Held held);
  Held let_go(FactId taken);

  // The lease that a standing fact goes with, and the one that a taken fact is held under; 0 where there is none.
  LeaseId lease_of(FactId standing) const;
  LeaseId holder_of(FactId taken) const;
  // Its lease has ended.
  bool is_to_go(FactId standing) const;
  // The first fact that fits and stays, where some are to go.
  const Fact* first_standing(const FactTable& table, const Datum& pattern, std::size_t& examined) const;
  // Whether facts stand that are to go.
  void set_lapsing(bool some) { some_lapse_ = some; }

  Revision revision() const { return revision_; }
  FactId next_id() const { return next_id_; }
  FactId take_id() { return next_id_++; }
  // What went before the horizon is not known.
  Revision horizon() const { return horizon_; }
  // As an earlier life of the board had them.
  void restore_counters(Revision revision, FactId next_id);
  void restore_next_id(FactId next_id) { next_id_ = next_id; }

 private:
  Tables tables_;
  mutable IndexMaker index_maker_;
  HashIndex<StandingFact> standing_;  // by their ids
  std::map<FactId, Held> held_;
  std::size_t bytes_ = 0;
  Leases leases_;
  std::set<std::pair<Time, FactId>> expiries_;
  bool some_lapse_ = false;
  Revision revision_ = 0;
  Revision horizon_ = 0;
  FactId next_id_ = 1;
};

std::unexpected<Failure> unknown_lease(LeaseId lease);

}  // namespace pizarra::store
