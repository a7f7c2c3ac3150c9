#pragma once

// A served board's duty to clients whose changes must last: it answers them only when the disk has what they were told,
// and it answers a question about durable facts only when the disk has those that it tells of.
//
//   const Result<Durability::Before> before = durability.begin(store, body);
//   if (!before) refuse(before.error());                              // else the request is done
//   const Durability::After after = durability.end(store, body, *before);
//   if (after.awaited > 0) durability.hold(session, request, {reply, after.awaited});
//
// Held replies are given to `send` in order, when the journal has all that came before them. Nothing is begun that the
// journal has no space for; should it not be written even so, those whose changes stand already are answered with the
// failure `not-durable`, whose subject is what they would have been answered.

#include <deque>
#include <functional>
#include <string>

#include "blackboard/journal/journal_writer.hpp"
#include "blackboard/wire/wire.hpp"

namespace pizarra::server {

class Durability {
 public:
  using Send = std::function<void(wire::SessionId session, const std::string& reply)>;
  using Position = journal::JournalWriter::Position;

  struct Reply {
    std::string text;
    Position after = 0;   // not to be given before this is in the journal
    bool stands = false;  // whether it tells of a change, which is on the board already
  };

  // Without a journal nothing is durable.
  // `of_all`: every answer waits for what came before it, not only those about durable facts.
  Durability(journal::JournalWriter* journal, Send send, bool of_all = false);
  Durability(const Durability&) = delete;
  Durability& operator=(const Durability&) = delete;
  ~Durability();

  struct Before {
    bool durable = false;      // whether the request tells, retracts, takes, settles or declares what is durable
    Position journal_end = 0;  // where the journal ended
  };
  // Before a request is done. Failure journal-full: then it is not to be done. Where the disk is full, what takes
  // durable facts away and adds none goes on.
  Result<Before> begin(const store::Store& store, const Datum& body) const;
  // The same with what its retractions take away, each fact of which the journal names.
  Result<void> check_room(const store::Store& store, const Datum& body, const Transaction& transaction) const;
  struct After {
    bool changed = false;  // whether what is durable is another now
    Position awaited = 0;  // the journal must be written up to here before it is answered; 0: it need not wait
  };
  // After it was done.
  After end(const store::Store& store, const Datum& body, const Before& before);
  // Whether the journal has all that happened.
  bool has_all() const { return journal_ == nullptr || journal_->position() <= journal_->kept(); }
  void hold(wire::SessionId session, wire::RequestId request, Reply reply);
  // One that was held before, if it is to be had.
  void answer_again(wire::SessionId session, wire::RequestId request, const Reply& reply) const;
  void remember(const journal::RememberedReply& reply) { journal_->remember(reply); }

 private:
  struct Held {
    wire::SessionId session;
    wire::RequestId request;
    Reply reply;
  };
  using Change = journal::JournalWriter::Change;
  static Change change_of(const Datum& body, bool durable);
  bool concerns_durable(const store::Store& store, const Datum& body) const;
  Position awaited(const store::Store& store, const Datum& body, bool durable) const;
  Position position() const { return journal_ == nullptr ? 0 : journal_->position(); }
  Result<void> check_room(const Datum& body, bool durable, std::size_t removals) const;
  void progress();
  std::string in_doubt(wire::RequestId request, const Reply& reply) const;

  journal::JournalWriter* const journal_;
  const Send send_;
  const bool of_all_;
  Position last_change_ = 0;  // of what is durable
  std::deque<Held> held_;
};

}  // namespace pizarra::server
