#pragma once

// Replies that a client is given when the disk has what they tell of. They go in order, as the journal is written.
// Should it not be written, those whose changes stand already are answered with the failure `not-durable`, whose
// subject is what they would have been answered.
//
//   HeldReplies held(journal, [&](wire::SessionId session, const std::string& reply) { ... });
//   if (after.awaited > 0) held.hold(session, request, {reply, after.awaited});

#include <deque>
#include <functional>
#include <string>

#include "blackboard/journal/journal_writer.hpp"
#include "blackboard/wire/wire.hpp"

namespace pizarra::server {

class HeldReplies {
 public:
  using Send = std::function<void(wire::SessionId session, const std::string& reply)>;
  using Position = journal::JournalWriter::Position;

  struct Reply {
    std::string text;
    Position after = 0;   // not to be given before this is in the journal
    bool stands = false;  // whether it tells of a change, which is on the board already
  };

  // Without a journal none is held.
  HeldReplies(journal::JournalWriter* journal, Send send);
  HeldReplies(const HeldReplies&) = delete;
  HeldReplies& operator=(const HeldReplies&) = delete;
  ~HeldReplies();

  void hold(wire::SessionId session, wire::RequestId request, Reply reply);
  // One that was held before, if it is to be had.
  void answer_again(wire::SessionId session, wire::RequestId request, const Reply& reply) const;

 private:
  struct Held {
    wire::SessionId session;
    wire::RequestId request;
    Reply reply;
  };
  void progress();
  std::string in_doubt(wire::RequestId request, const Reply& reply) const;

  journal::JournalWriter* const journal_;
  const Send send_;
  std::deque<Held> held_;
};

}  // namespace pizarra::server
