#pragma once

// A served board's duty to clients whose changes must last: it answers them only when the disk has what they were told,
// and it answers a question about durable facts only when the disk has those that it tells of.
//
//   const Result<Durability::Before> before = durability.begin(store, body);
//   if (!before) refuse(before.error());                              // else the request is done
//   const Durability::After after = durability.end(store, body, *before);
//   if (after.awaited > 0) held.hold(session, request, {reply, after.awaited});     // held_replies.hpp
//
// Nothing is begun that the journal has no space for.

#include "blackboard/journal/journal_writer.hpp"
#include "blackboard/store/store.hpp"

namespace pizarra::server {

class Durability {
 public:
  using Position = journal::JournalWriter::Position;

  // Without a journal nothing is durable.
  // `of_all`: every answer waits for what came before it, not only those about durable facts.
  explicit Durability(journal::JournalWriter* journal, bool of_all = false) : journal_(journal), of_all_(of_all) {}

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
  void remember(const journal::RememberedReply& reply) { journal_->remember(reply); }

 private:
  using Change = journal::JournalWriter::Change;
  static Change change_of(const Datum& body, bool durable);
  bool concerns(const store::Store& store, const Datum& body) const;
  Position awaited(const store::Store& store, const Datum& body, bool durable) const;
  Position position() const { return journal_ == nullptr ? 0 : journal_->position(); }
  Result<void> check_room(const Datum& body, bool durable, std::size_t removals) const;

  journal::JournalWriter* const journal_;
  const bool of_all_;
  Position last_change_ = 0;  // of what is durable
};

}  // namespace pizarra::server
