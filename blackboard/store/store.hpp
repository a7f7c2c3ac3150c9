#pragma once

// The facts themselves: one thread, no clock of its own, the same calls give the same contents and the same commits.
//
// Every call that may change something is given the time. Leases and leased facts lapse when expire() is called, each
// lapse one transaction told by "board": those that were due at next_expiry() or later stand until then.
//
// The facts and their places are KeptFacts (kept_facts.hpp). A transaction is checked (transaction_check.hpp) and then
// done (transaction_change.hpp); what lapses goes in parts (lapsing.hpp); what a journal holds lives again
// (revival.hpp).
//
//   Store store;
//   store.on_commit([&](const Commit& commit) { ... });
//   store.declare({relation});
//   store.transact("vision", transaction, now);

#include "blackboard/board.hpp"
#include "blackboard/store/lapsing.hpp"
#include "blackboard/store/revival.hpp"

namespace pizarra::store {

class Store {
 public:
  // A board that may live again in the same agents' lifetime begins with a lease that no earlier life has given out.
  explicit Store(LeaseId first_lease = 1) : kept_(first_lease) {}
  Store(const Store&) = delete;
  Store& operator=(const Store&) = delete;

  void on_commit(std::function<void(const Commit&)> take) { kept_.on_commit = std::move(take); }

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
  // As of Lapsing.
  Result<void> release(LeaseId lease, Time now, std::size_t& examined) {
    return lapsing_.release(lease, now, examined);
  }
  std::optional<Time> next_expiry() const { return lapsing_.next_expiry(); }
  void expire(Time due, Time now, std::size_t& left) { lapsing_.expire(due, now, left); }
  // The same for who does not go on meanwhile.
  Result<void> release(LeaseId lease, Time now) {
    std::size_t examined = 0;
    return release(lease, now, examined);
  }
  void expire(Time due, Time now) {
    std::size_t left = Lapsing::lapsing_at_once;
    expire(due, now, left);
  }

  const Tables& tables() const { return kept_.tables(); }
  IndexMaker& index_maker() const { return kept_.index_maker(); }
  Revision revision() const { return kept_.revision(); }
  std::size_t size() const { return kept_.size(); }
  // A taken fact that is neither settled nor put back.
  const Fact* held(FactId id) const;
  // Such a one, or one that stands.
  const Fact* fact(FactId id) const;
  // All of those, by ascending id, and whether they were told under a lease.
  std::vector<std::pair<Fact, bool>> taken() const;
  FactId next_fact() const { return kept_.next_id(); }
  bool stands(LeaseId lease) const { return kept_.leases().contains(lease); }
  // As of KeptFacts.
  LeaseId lease_of(FactId standing) const { return kept_.lease_of(standing); }
  LeaseId holder_of(FactId taken) const { return kept_.holder_of(taken); }

  // As of revival.hpp.
  Result<void> restore(Fact fact, Restored as) { return store::restore(kept_, std::move(fact), as); }
  void restore_counters(Revision revision, FactId next_fact) { kept_.restore_counters(revision, next_fact); }
  // Of a store that has given out none: when it is known which ones an earlier life cannot have given out.
  void begin_leases_at(LeaseId first) { kept_.leases().begin_at(first); }
  Result<void> apply(Commit commit) { return store::apply(kept_, std::move(commit)); }
  void resume(Time now) { store::resume(kept_, now); }

 private:
  KeptFacts kept_;
  Lapsing lapsing_{kept_};
};

}  // namespace pizarra::store
