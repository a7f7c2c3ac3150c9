#pragma once

// The rights of a client with a key on a board: its permissions (keys.hpp), held against each request before the board
// sees it. Leases and what is held under them belong to the key that asked for them.
//
//   KeyRights rights(board);
//   const Result<void> permitted = rights.ask(key, query);       // failure not-permitted
//
// A client without a key is one of this machine: it may do everything, but have leases without end.

#include <map>
#include <set>
#include <string>

#include "blackboard/memory/memory_board.hpp"
#include "blackboard/wire/keys.hpp"

namespace pizarra::server {

class KeyRights {
 public:
  // Several clients may come with one key.
  using Key = const wire::PublicKey*;
  static constexpr std::size_t most_leases = 4096;  // of all clients of one key, or of one name without

  explicit KeyRights(const memory::MemoryBoard& board) : board_(board) {}

  // Whether it may tell, take or read some of its facts, or no key is asked for.
  static bool may_know(Key key, std::string_view relation);
  // Permitted to a key that may tell, take or read the relation's facts. Others learn nothing of how it is declared.
  // Failure too-large, where there are too many relations of one beginning.
  Result<void> declare(Key key, const std::vector<Relation>& relations) const;
  // Adds to `examined` the facts that it looked at to find their owners: they count as the transaction's own. Failure
  // too-costly.
  Result<void> transact(Key key, const Transaction& transaction, std::size_t& examined) const;
  Result<void> ask(Key key, const Query& query) const;
  Result<void> take(Key key, const Datum& pattern, LeaseId holder) const;
  Result<void> use_lease(Key key, LeaseId lease) const;
  // `name` is the key's, or else the client's. Failure too-large.
  Result<void> lease(Key key, const std::string& name);
  void granted(Key key, const std::string& name, LeaseId lease) { leases_[{name, key != nullptr}].insert(lease); }
  // Forgets the leases that have lapsed.
  void sweep();

 private:
  using Owner = std::pair<std::string, bool>;  // a name, and whether it is a key's

  void forget_lapsed(std::set<LeaseId>& leases) const;
  Result<void> check(const wire::PublicKey& key, const Transaction::Precondition& precondition) const;
  Result<void> check(const wire::PublicKey& key, const Transaction::Step& step, std::size_t& examined) const;
  Result<void> leave_to_others(const wire::PublicKey& key, const Datum& told, const Datum& pattern,
                               std::size_t& examined) const;

  const memory::MemoryBoard& board_;
  std::map<Owner, std::set<LeaseId>> leases_;
};

}  // namespace pizarra::server
