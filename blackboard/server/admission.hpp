#pragma once

// Who a served board lets in: the keys that may connect, the hellos that begin a session, and the sessions that end
// when their key goes or their client falls silent.
//
//   Admission admission(board, sessions, refusals, outbox, socket, std::move(keys), life);
//   admission.greet(peer, hello, now);           // answers with a welcome, or says why not
//   admission.refuse(peer, failure);             // whatever else was wrong with a message
//   admission.end_silent(now - session_length);  // and those whose key has changed

#include <optional>
#include <string>

#include "blackboard/memory/memory_board.hpp"
#include "blackboard/server/key_folder.hpp"
#include "blackboard/server/outbox.hpp"
#include "blackboard/server/refusals.hpp"
#include "blackboard/server/sessions.hpp"

namespace pizarra::server {

class Admission {
 public:
  // `life`: another one in every life of the server. Without keys nobody is asked for one.
  Admission(memory::MemoryBoard& board, Sessions& sessions, Refusals& refusals, Outbox& outbox,
            wire::FrameSocket& socket, std::optional<KeyFolder> keys, wire::SessionId life);
  Admission(const Admission&) = delete;
  Admission& operator=(const Admission&) = delete;
  ~Admission() = default;

  // Null where none are asked for.
  const KeyFolder* keys() const { return keys_ ? &*keys_ : nullptr; }
  void greet(const std::string& peer, const Datum& hello, Time now);
  void refuse(const std::string& peer, const Failure& failure);
  // The sender of the message in hand: its session's client, else its key's name, else nothing.
  std::string who_is(const std::string& peer) const;
  void end(wire::SessionId id);
  // Those that were heard last then or before, and those of keys that have changed.
  void end_silent(Time heard);

 private:
  void ask_for_keys();
  Result<void> check_hello(const std::string& peer, const std::string& teller, const wire::PublicKey* key) const;
  void end_those_of_changed_keys();

  memory::MemoryBoard& board_;
  Sessions& sessions_;
  Refusals& refusals_;
  Outbox& outbox_;
  wire::FrameSocket& socket_;
  std::optional<KeyFolder> keys_;
  const wire::SessionId life_;
};

}  // namespace pizarra::server
