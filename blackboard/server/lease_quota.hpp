#pragma once

// How many leases each client has: who asks for them without end takes no other's.
//
//   LeaseQuota quota(board);
//   const Result<void> more = quota.check("alice");       // too-large
//   quota.granted("alice", lease);

#include <map>
#include <set>
#include <string>

#include "blackboard/memory/memory_board.hpp"

namespace pizarra::server {

class LeaseQuota {
 public:
  static constexpr std::size_t most = 4096;  // of all clients of one name

  explicit LeaseQuota(const memory::MemoryBoard& board) : board_(board) {}

  Result<void> check(const std::string& teller);
  void granted(const std::string& teller, LeaseId lease) { leases_[teller].insert(lease); }
  // Forgets those that have lapsed.
  void sweep();

 private:
  void forget_lapsed(std::set<LeaseId>& leases) const;

  const memory::MemoryBoard& board_;
  std::map<std::string, std::set<LeaseId>> leases_;
};

}  // namespace pizarra::server
