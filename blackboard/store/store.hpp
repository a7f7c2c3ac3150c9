#pragma once

// The facts themselves: one thread, no clock of its own, the same calls give the same contents and the same commits.
//
// Every call that may change something is given the time. Leases and leased facts lapse when expire() is called, each
// lapse one transaction told by "board": those that were due at next_expiry() or later stand until then.
//
//   Store store;
//   store.on_commit = [&](const Commit& commit) { ... };
//   store.declare({relation});
//   store.transact("vision", transaction, now);

#include <functional>
#include <memory>

#include "blackboard/board.hpp"
#include "blackboard/store/commit.hpp"
#include "blackboard/store/fact_table.hpp"
#include "blackboard/store/index_maker.hpp"
#include "blackboard/store/leases.hpp"

namespace pizarra::store {

class Store {
 public:
  // A board that may live again in the same agents' lifetime begins with a lease that no earlier life has given out.
  explicit Store(LeaseId first_lease = 1) : leases_(first_lease) {}
  Store(const Store&) = delete;
  Store& operator=(const Store&) = delete;

  std::function<void(const Commit&)> on_commit;

  // Answers those that are new.
  Result<std::vector<Relation>> declare(const std::vector<Relation>& relations);
  // These add to `examined` how many facts they looked at, and fail beyond limits::examined; with awaits-index where an
  // index is made in parts for them (indexing.hpp), and nothing is changed.
  Result<Revision> transact(const std::string& teller, const Transaction& transaction, Time now, std::size_t& examined);
  Result<Answers> ask(const Query& query, std::size_t& examined) const;
  // With holder 0 the fact is removed for good.
  Result<std::optional<Fact>> take(const std::string& teller, const Datum& pattern, LeaseId holder, Time now,
                                   std::size_t& examined);
  // The same for who does not want to know.
  Result<Revision> transact(const std::string& teller, const Transaction& transaction, Time now) {
    std::size_t examined = 0;
    return transact(teller, transaction, now, examined);
  }
  Result<Answers> ask(const Query& query) const {
    std::size_t examined = 0;
    return ask(query, examined);
  }
  Result<std::optional<Fact>> take(const std::string& teller, const Datum& pattern, LeaseId holder, Time now) {
    std::size_t examined = 0;
    return take(teller, pattern, holder, now, examined);
  }

  Result<LeaseId> lease(Duration length, Time now);
  Result<void> renew(LeaseId lease, Time now);
  // Lapsing takes as long as looking at so many facts: more, where a relation has indexes. Facts beyond that are due
  // too, and questions find them until they are removed; it is not taken, and no precondition finds it.
  static constexpr std::size_t lapsing_at_once = 8000;
  // Adds to `examined` what that took.
  Result<void> release(LeaseId lease, Time now, std::size_t& examined);
  std::optional<Time> next_expiry() const;
  // Lapses what was due by `due`, the least first, until nothing is left of `left`.
  void expire(Time due, Time now, std::size_t& left);
  // The same for who does not go on meanwhile.
  Result<void> release(LeaseId lease, Time now) {
    std::size_t examined = 0;
    return release(lease, now, examined);
  }
  void expire(Time due, Time now) {
    std::size_t left = lapsing_at_once;
    expire(due, now, left);
  }

  const Tables& tables() const { return tables_; }
  // The speed at which a fact is found is no part of the board's content.
  IndexMaker& index_maker() const { return index_maker_; }
  Revision revision() const { return revision_; }
  std::size_t size() const { return standing_.size(); }
  // A taken fact that is neither settled nor put back.
  const Fact* held(FactId id) const;
  // Such a one, or one that stands.
  const Fact* fact(FactId id) const;
  // All of those, by ascending id, and whether they were told under a lease.
  std::vector<std::pair<Fact, bool>> taken() const;
  FactId next_fact() const { return next_fact_; }
  bool stands(LeaseId lease) const { return leases_.contains(lease); }
  // The lease that a standing fact goes with, and the one that a taken fact is held under; 0 where there is none.
  LeaseId lease_of(FactId standing) const;
  LeaseId holder_of(FactId taken) const;

  // The facts that stood or were taken at the revision where a journal begins, by ascending id, each with whether it
  // was told under a lease; then its counters.
  enum class Restored : std::uint8_t { standing, taken, leased, taken_leased };
  Result<void> restore(Fact fact, Restored as);
  void restore_counters(Revision revision, FactId next_fact);
  // Of a store that has given out none: when it is known which ones an earlier life cannot have given out.
  void begin_leases_at(LeaseId first) { leases_.begin_at(first); }
  // Repeats a commit of another store, in order; a failure says why it cannot have happened here. Of facts that it
  // removes, only the ids need be known.
  Result<void> apply(Commit commit);
  // After the last apply, makes the store live: facts of relations that are not durable go, and durable ones that stood
  // under a lease, for no lease outlives the board that gave it; what was taken comes back, and leased relations' facts
  // begin their leases.
  void resume(Time now);

 private:
  struct Held {
    Fact fact;
    LeaseId holder;
    LeaseId told_under;  // 0 for none
  };
  class Change;
  class Check;

  StandingFact* find(FactId standing) const;
  StandingFact& put(FactTable& table, Fact fact);
  Fact replace(StandingFact& standing, Fact fact);
  StandingFact remove(StandingFact& standing, Revision revision);
  void hold(Held held);
  Held let_go(FactId taken);
  static std::unexpected<Failure> unknown_lease(LeaseId lease);
  const Fact* first_standing(const FactTable& table, const Datum& pattern, std::size_t& examined) const;
  // Its lease has ended.
  bool is_to_go(FactId standing) const;
  void keep_lapsing(LeaseId lease, Leases::Lease under_it);
  void lapse_some(LeaseId lease, Leases::Lease& under_it, std::size_t& left, Time now);
  void lapse_facts(Time due, std::size_t& left, Time now);
  Result<void> apply_entry(const Commit& commit, Commit::Entry& entry);

  Tables tables_;
  mutable IndexMaker index_maker_;
  HashIndex<StandingFact> standing_;  // by their ids
  std::map<FactId, Held> held_;
  std::size_t bytes_ = 0;  // of what stands or is held
  Leases leases_;
  std::multimap<std::size_t, std::pair<LeaseId, Leases::Lease>> lapsing_;  // by how much is still to go with them
  std::set<std::pair<Time, FactId>> fact_expiries_;
  Revision revision_ = 0;
  Revision horizon_ = 0;  // what went before is not known
  FactId next_fact_ = 1;
};

}  // namespace pizarra::store
