#pragma once

// What a served board owes those whose changes must last: it answers them only when the disk has what they were told.
//
//   if (durability.concerns_durable(store, body)) durability.hold(session, request, reply);
//
// Held replies are given to `send` in order, when the journal has all that came before them. When the journal cannot
// be written, they are answered with its failure: what they are about stands, and is written when there is space again.

#include <deque>
#include <functional>
#include <string>

#include "blackboard/journal/journal_writer.hpp"
#include "blackboard/wire/wire.hpp"

namespace pizarra {

class Durability {
 public:
  using Send = std::function<void(wire::SessionId session, const std::string& reply)>;

  // Without a journal nothing is durable.
  Durability(JournalWriter* journal, Send send);
  Durability(const Durability&) = delete;
  Durability& operator=(const Durability&) = delete;
  ~Durability();

  // Whether the request tells, retracts, takes, settles or declares what is durable.
  bool concerns_durable(const Store& store, const Datum& body) const;
  // Before a change: failure journal-full.
  Result<void> check_room(const Datum& body, bool durable) const;
  JournalWriter::Position position() const { return journal_ == nullptr ? 0 : journal_->position(); }
  bool kept(JournalWriter::Position position) const { return journal_ == nullptr || position <= journal_->kept(); }
  void hold(wire::SessionId session, wire::RequestId request, std::string reply);
  void remember(const RememberedReply& reply) { journal_->remember(reply); }

 private:
  struct Held {
    JournalWriter::Position position;
    wire::SessionId session;
    wire::RequestId request;
    std::string reply;
  };
  void progress();

  JournalWriter* const journal_;
  const Send send_;
  std::deque<Held> held_;
};

}  // namespace pizarra
