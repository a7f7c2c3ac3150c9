#pragma once

// The messages of a client that wait, in order. The first waits for an index that it needs, for the client's turn
// (workload.hpp), or because the frame that it came with has cost enough for once. The others wait behind it. A
// request that waited is done anew.
//
//   postponed.wait(std::move(message));        // whatever there is stays behind it
//   postponed.add({message});                  // false where there is no room
//   Postponed::Message next = postponed.next();

#include <deque>
#include <set>

#include "blackboard/server/replies.hpp"
#include "blackboard/wire/wire.hpp"
#include "lisp/datum.hpp"

namespace pizarra::server {

class Postponed {
 public:
  static constexpr std::size_t most = 2048;
  // Of the messages. No more than are remembered, so a client that was cut off can ask for each answer again.
  static constexpr std::size_t most_requests = KeptReplies::most;
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
