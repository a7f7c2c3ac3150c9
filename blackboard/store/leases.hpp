#pragma once

// The leases of a store, what stands under each, and when they lapse.
//
//   LeaseId lease = leases.grant(2s, now);
//   leases.facts(lease).insert(fact);            // goes when the lease lapses
//   leases.next_expiry();                        // lapse it then, unless it is renewed

#include <map>
#include <optional>
#include <set>
#include <unordered_map>
#include <utility>

#include "blackboard/fact.hpp"

namespace pizarra::store {

class Leases {
 public:
  struct Lease {
    Duration length{};
    Time expiry{};
    std::set<FactId> facts;  // that stand while it does
    std::set<FactId> held;   // taken, to be put back
  };

  explicit Leases(LeaseId first) : next_(first) {}
  void begin_at(LeaseId first) { next_ = first; }

  LeaseId grant(Duration length, Time now) {
    const LeaseId id = next_++;
    leases_[id] = {length, now + length, {}, {}};
    expiries_.emplace(now + length, id);
    return id;
  }
  Lease* find(LeaseId id) {
    const auto found = leases_.find(id);
    return found == leases_.end() ? nullptr : &found->second;
  }
  bool contains(LeaseId id) const { return leases_.contains(id); }
  // It must be there.
  void renew(LeaseId id, Time now) {
    Lease& lease = leases_.at(id);
    expiries_.erase({lease.expiry, id});
    lease.expiry = now + lease.length;
    expiries_.emplace(lease.expiry, id);
  }
  // From now on there is none of this id, of which there must be one; what goes with it, the caller lets go.
  Lease remove(LeaseId id) {
    const auto found = leases_.find(id);
    Lease lease = std::move(found->second);
    expiries_.erase({lease.expiry, id});
    leases_.erase(found);
    return lease;
  }
  std::size_t size() const { return leases_.size(); }
  // The lease that lapses first, and when.
  std::optional<std::pair<Time, LeaseId>> first() const {
    if (expiries_.empty()) return std::nullopt;
    return *expiries_.begin();
  }

 private:
  LeaseId next_;
  std::unordered_map<LeaseId, Lease> leases_;
  std::set<std::pair<Time, LeaseId>> expiries_;
};

}  // namespace pizarra::store
