#pragma once

// The requests that a served board's clients make of it, and their replies: each is done once, however often it is
// asked.
//
//   Requests requests(executor, board, sessions, refusals, workload, outbox, {.journal = journal});
//   if (requests.is_to_be_done(id, session, number, body)) ...        // else it is answered, or being answered
//   if (!requests.serve(id, session, {message})) ...                  // it must wait for an index, or its turn
//
// A client's last replies are remembered (replies.hpp). A request about durable facts is answered when the journal has
// it (durability.hpp, held_replies.hpp). A question about the past is answered from the journal.

#include <optional>
#include <set>
#include <string>

#include "blackboard/journal/past.hpp"
#include "blackboard/memory/memory_board.hpp"
#include "blackboard/server/durability.hpp"
#include "blackboard/server/held_replies.hpp"
#include "blackboard/server/outbox.hpp"
#include "blackboard/server/permitted_board.hpp"
#include "blackboard/server/refusals.hpp"
#include "blackboard/server/sessions.hpp"
#include "blackboard/server/workload.hpp"

namespace pizarra::server {

class Requests {
 public:
  struct Journals {
    journal::JournalWriter* journal = nullptr;  // null: nothing is durable
    journal::JournalWriter* past = nullptr;     // from which the past is answered; null: from the same
    bool answers_from_journal = false;          // every answer waits until it has what came before
  };

  // All of them outlive it.
  Requests(Executor& executor, memory::MemoryBoard& board, Sessions& sessions, Refusals& refusals, Workload& workload,
           Outbox& outbox, const Journals& journals);
  Requests(const Requests&) = delete;
  Requests& operator=(const Requests&) = delete;
  ~Requests() = default;

  PermittedBoard& permitted() { return permitted_; }
  // Whether a request that came is to be done, now or in its turn. Otherwise it is answered, or being answered.
  bool is_to_be_done(wire::SessionId id, Session& session, wire::RequestId number, const Datum& body);
  // False where it must wait; it is then to be done anew.
  bool serve(wire::SessionId id, Session& session, const Postponed::Message& waiting);
  void refuse(const Session& session, wire::RequestId number, const Failure& failure);
  // One that was not done. When it comes again it is refused as well, though it could be done by then.
  void refuse_undone(Session& session, wire::RequestId number, const Datum& body, const Failure& failure);
  // Replies of a former life of the board.
  void restore(const std::vector<journal::RememberedReply>& remembered);

 private:
  bool was_answered(wire::SessionId id, const Session& session, wire::RequestId number, const Datum& body);
  std::optional<Result<Datum>> perform_in_turn(wire::SessionId id, Session& session, const Postponed::Message& waiting);
  struct Done {
    wire::RequestId number;
    const Datum& body;
    Durability::Before before;
  };
  void answer(wire::SessionId id, Session& session, const Done& done, const Result<Datum>& result);
  Result<Datum> watch(wire::SessionId id, Session& session, const Datum& body, std::size_t& examined);
  bool asks_past(const Datum& body) const;
  void ask_past(wire::SessionId id, const Session& session, wire::RequestId number, const Datum& body);
  void note_journey(const Datum& body, Time sent);

  Executor& executor_;
  memory::MemoryBoard& board_;
  Sessions& sessions_;
  Refusals& refusals_;
  Workload& workload_;
  Outbox& outbox_;
  Durability durability_;
  HeldReplies held_;
  PermittedBoard permitted_;
  std::optional<journal::Past> past_;
  std::set<std::pair<wire::SessionId, wire::RequestId>> past_asked_;
};

}  // namespace pizarra::server
