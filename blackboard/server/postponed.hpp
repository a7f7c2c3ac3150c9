#pragma once

// The messages of a client that wait: for an index that one of its requests needs, which is then done anew, or for its
// turn (turns.hpp), or since much was done of the frame that it came with; and behind that one, so that each is done
// when those before it are.
//
//   postponed.wait(std::move(message));        // whatever there is stays behind it
//   postponed.add({message});                  // false where there is no room
//   Postponed::Message next = postponed.next();

#include <deque>
#include <set>

#include "blackboard/server/answered.hpp"
#include "blackboard/wire/wire.hpp"
#include "lisp/datum.hpp"

namespace pizarra::server {

class Postponed {
 public:
  static constexpr std::size_t most = 2048;
  // Of these. So a client that is cut off and asks each again learns what came of it.
  static constexpr std::size_t most_requests = Answered::most;
  static constexpr std::size_t most_bytes = 4 << 20;
  static constexpr std::size_t most_waits = 64;  // of a message

  struct Message {
    Datum datum;
    std::size_t waits = 0;  // for an index, or its turn

    // So its turn has come.
    bool has_waited() const { return waits > 0; }
    bool may_wait() const { return waits < most_waits; }
  };

  bool empty() const { return messages_.empty(); }
  bool has_request(wire::RequestId number) const { return requests_.contains(number); }
  bool add(Message message);
  void wait(Message message);
  Message next();

 private:
  std::deque<Message> messages_;
  std::set<wire::RequestId> requests_;
  std::size_t bytes_ = 0;
};

}  // namespace pizarra::server
