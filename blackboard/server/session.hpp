#pragma once

// A served board's record of one client, from its hello until the client is silent for too long.

#include <optional>
#include <string>

#include "blackboard/server/answered.hpp"
#include "blackboard/server/permitted_board.hpp"
#include "blackboard/server/postponed.hpp"
#include "blackboard/server/served_watches.hpp"
#include "blackboard/store/indexing.hpp"

namespace pizarra::server {

struct Session {
  std::string teller;
  std::string peer;  // its connection; one that a former life of the board had has none before it greets
  std::optional<wire::PublicKey> key;
  Time heard{};
  ServedWatches watches;
  bool holds = false;  // copies of what it watches, from which it answers questions itself
  Answered done;
  Answered refused;                // and not done
  store::IndexTicket awaited = 0;  // by its watches, or the first of what is postponed
  Postponed postponed;

  // The identity that its requests are counted under: its key's name, or else its teller's.
  const std::string& client() const { return key ? key->name : teller; }
  PermittedBoard::Client asking() const { return {teller, client(), key ? &*key : nullptr}; }
};

}  // namespace pizarra::server
