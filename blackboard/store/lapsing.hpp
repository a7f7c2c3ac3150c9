#pragma once

// The facts that go, or come back, when a lease ends; and leased facts in their time. A part at a time: of the leases
// that have ended, the one with the least to go is next, so that nobody's many facts hold back another's few.
//
//   Lapsing lapsing(kept);
//   lapsing.expire(due, now, left);           // when lapsing.next_expiry() has come

#include <map>
#include <optional>

#include "blackboard/store/kept_facts.hpp"

namespace pizarra::store {

class Lapsing {
 public:
  // Lapsing takes as long as looking at so many facts: more, where a relation has indexes. Facts beyond that are due
  // too, and questions find them until they are removed; it is not taken, and no precondition finds it.
  static constexpr std::size_t lapsing_at_once = 8000;

  // `kept` outlives it.
  explicit Lapsing(KeptFacts& kept) : kept_(kept) {}

  // Ends the lease. Adds to `examined` what that took.
  Result<void> release(LeaseId lease, Time now, std::size_t& examined);
  std::optional<Time> next_expiry() const;
  // Lapses what was due by `due`, the least first, until nothing is left of `left`.
  void expire(Time due, Time now, std::size_t& left);

 private:
  void keep_lapsing(LeaseId lease, Leases::Lease under_it);
  void lapse_some(LeaseId lease, Leases::Lease& under_it, std::size_t& left, Time now);
  void lapse_facts(Time due, std::size_t& left, Time now);

  KeptFacts& kept_;
  std::multimap<std::size_t, std::pair<LeaseId, Leases::Lease>> lapsing_;  // by how much is still to go with them
};

}  // namespace pizarra::store
