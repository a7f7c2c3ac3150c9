#pragma once

// The board as its clients may use it: what they ask for in the forms of the wire (wire.hpp), within what their keys
// permit and the leases that they may have.
//
//   PermittedBoard permitted(board, durability);
//   Result<Datum> value = permitted.perform({.teller = "eyes", .name = "eyes"}, body, examined);    // of its reply

#include <functional>
#include <memory>
#include <string>

#include "blackboard/memory/memory_board.hpp"
#include "blackboard/server/durability.hpp"
#include "blackboard/server/key_rights.hpp"

namespace pizarra::server {

class PermittedBoard {
 public:
  struct Client {
    const std::string& teller;
    const std::string& name;  // the owner of its requests: the key's name, or else the client's
    KeyRights::Key key = nullptr;
  };

  // Both outlive it.
  PermittedBoard(memory::MemoryBoard& board, const Durability& durability)
      : board_(board), durability_(durability), rights_(board) {}

  // The value of the reply to any request but a watch. Adds to `examined` how many facts were looked at.
  Result<Datum> perform(const Client& client, const Datum& body, std::size_t& examined);
  Result<std::unique_ptr<watch::WatchQueue>> watch(const Client& client, const Datum& query,
                                                   std::function<void()> ready, std::shared_ptr<watch::Backlog> backlog,
                                                   std::size_t& examined);
  // The value of the reply to `(recall QUERY)`, of a board that led so long ago.
  Result<Datum> recall(const Client& client, const Datum& body, Duration age, std::size_t& examined);
  // The query of `(ask QUERY)` and its like.
  Result<Query> query_of(const Client& client, const Datum& body) const;
  // Takes from the answers what this client may not read: facts that are the reasons of others (store/provenance.hpp).
  static void leave_out_unreadable(const Client& client, Answers& answers);
  // A failure as this client is told it: it hears of no relation that is none of its business.
  Failure told(const Client& client, Failure failure, std::size_t& examined) const;
  // Forgets what was known of leases that have lapsed.
  void sweep() { rights_.sweep(); }

 private:
  Result<Datum> act(const Client& client, const Datum& body, std::size_t& examined);
  Result<Datum> declare(const Client& client, const Datum& body);
  Result<Datum> transact(const Client& client, const Datum& body, std::size_t& examined);
  Result<Datum> ask(const Client& client, const Datum& body, std::size_t& examined);
  Result<Answers> answers_for(const Client& client, const Query& query, std::size_t& examined);
  Result<Datum> take(const Client& client, const Datum& body, std::size_t& examined);
  Result<Datum> lease(const Client& client, const Datum& body, std::size_t& examined);

  memory::MemoryBoard& board_;
  const Durability& durability_;
  KeyRights rights_;
};

}  // namespace pizarra::server
