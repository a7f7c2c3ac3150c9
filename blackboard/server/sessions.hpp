#pragma once

// The sessions of a served board: how one is found, begins, moves to another connection, and ends.
//
//   Sessions sessions(Sessions::random_number);
//   Result<Sessions::Begun> begun = sessions.begin(peer, "alice", 0, nullptr);
//   sessions.find(begun->id)->watches;
//   sessions.of_peer(peer);                          // a connection has one session
//
// A session belongs to its key, or to its teller where it has none. Its number cannot be guessed. One that was restored
// has no connection before its client comes back, and takes no room from those who come for the first time. A client
// that comes back is never refused: it would not learn what was done for it.

#include <functional>
#include <map>
#include <optional>
#include <string>

#include "blackboard/server/permitted_board.hpp"
#include "blackboard/server/postponed.hpp"
#include "blackboard/server/replies.hpp"
#include "blackboard/server/served_watches.hpp"
#include "blackboard/store/indexing.hpp"

namespace pizarra::server {

// The record of one client, from its hello until the client is silent for too long.
struct Session {
  std::string teller;
  std::string peer;  // its connection; one that a former life of the board had has none before it greets
  std::optional<wire::PublicKey> key;
  Time heard{};
  ServedWatches watches;
  bool holds = false;  // copies of what it watches, from which it answers questions itself
  KeptReplies done;
  KeptReplies refused;             // and not done
  store::IndexTicket awaited = 0;  // by its watches, or the first of what is postponed
  Postponed postponed;

  // The identity that its requests are counted under: its key's name, or else its teller's.
  const std::string& client() const { return key ? key->name : teller; }
  PermittedBoard::Client asking() const { return {teller, client(), key ? &*key : nullptr}; }
};

class Sessions {
 public:
  static constexpr std::size_t most = 1024;
  static constexpr std::size_t most_of_a_key = 64;
  static constexpr std::size_t most_of_a_name = 256;    // of those without a key
  static constexpr std::size_t most_remembered = 1024;  // of a former life

  // Fits a datum, and nobody guesses it.
  static std::uint64_t random_number();

  explicit Sessions(std::function<std::uint64_t()> number) : number_(std::move(number)) {}

  std::size_t size() const { return sessions_.size(); }
  const std::map<wire::SessionId, Session>& all() const { return sessions_; }
  // Null where there is none.
  Session* find(wire::SessionId id);
  std::optional<wire::SessionId> of_peer(const std::string& peer) const;
  // One that a former life of the board had, before any begins here. Null where there are most_remembered others.
  Session* restore(wire::SessionId id);

  struct Begun {
    wire::SessionId id;
    bool moved = false;  // from another connection: what was under way there may be lost
  };
  // The one that the connection has, the one asked for where it is the teller's, or a new one. Failure too-large.
  Result<Begun> begin(const std::string& peer, const std::string& teller, wire::SessionId asked,
                      const wire::PublicKey* key);
  // Answers whether its teller has no other.
  bool end(wire::SessionId id);

 private:
  Result<void> check_room(const std::string& teller, const wire::PublicKey* key) const;

  const std::function<std::uint64_t()> number_;
  std::map<wire::SessionId, Session> sessions_;
  std::map<std::string, wire::SessionId> of_peer_;
};

}  // namespace pizarra::server
