// When a request that came to a BoardServer is let in to the board: behind those of its client that wait, when the index
// is made that it needs, and as far as its client's quota goes. What each client has looked at is its debt.

#include "blackboard/server/board_server.hpp"
#include "blackboard/store/indexing.hpp"
#include "blackboard/store/store.hpp"

namespace pizarra {

namespace {

// What a client must be able to say at any time to keep what it has.
bool overtakes(const Datum& message) {
  const bool renews = message.is_form("request") && message.size() > 3 && message[3].is_form("renew");
  return renews || message.is_form("ack");
}

}  // namespace

bool BoardServer::must_wait(const Session& session, const Datum& message) {
  return !session.postponed.empty() && !overtakes(message);
}

void BoardServer::postpone(const Session& session, Postponed& postponed, const Datum& message) {
  const bool is_request = message.is_form("request");
  const std::optional<std::uint64_t> number = is_request ? wire::count_at(message, 2) : std::nullopt;
  // It is being answered.
  if (number && postponed.has_request(*number)) return;
  if (postponed.add({message})) return;
  const Failure full{"too-many", "too much waits behind a request for which an index is made", {}, {}};
  if (number) return refuse_request(session, *number, full);
  refuse(session.peer, full);
}

// Now, or when an index is made that it needs.
void BoardServer::serve(wire::SessionId id, Session& session, wire::RequestId number,
                        const Postponed::Message& waiting) {
  const Datum& message = waiting.datum;
  if (!waiting.was_let_in()) looks_.asked(id, client_of(session), executor_.now());
  const Revision before = board_.store().revision();
  if (!answer(id, session, number, waiting)) return session.postponed.wait(waiting);
  const bool timed = message.size() == 5;
  if (timed && board_.store().revision() > before) note_journey(message[3], Time(Duration(message[4].integer())));
}

// Whose quota is spent is refused what looks at more than a few facts; what has waited for an index was let in before.
// Nothing where it must wait for one.
std::optional<Result<Datum>> BoardServer::perform_within_quota(wire::SessionId id, Session& session,
                                                               const Postponed::Message& waiting) {
  const std::string& client = client_of(session);
  const bool is_spent = !waiting.was_let_in() && looks_.is_spent(client, executor_.now());
  const std::size_t before = is_spent ? LookQuota::all_but_few : 0;
  const bool may_wait = !is_spent && waiting.may_wait();
  const Indexing indexing(may_wait ? Indexing::May::make_in_parts : Indexing::May::not_make, client,
                          &board_.store().index_maker());
  std::size_t examined = before;
  Result<Datum> result = perform(id, session, waiting.datum[3], examined);
  const std::size_t looked_at = examined - before + indexing.examined();
  looks_.looked(client, looked_at, executor_.now());
  if (waiting.was_let_in()) examined_ += looked_at;
  if (indexing.awaited() != 0) {
    session.awaited = indexing.awaited();
    return std::nullopt;
  }
  const bool is_refused = is_spent && !result && result.error().symbol == "too-costly";
  if (!is_refused) return result;
  board_.statistics().requests().refuse(client, executor_.now());
  return looks_.refusal(client);
}

}  // namespace pizarra
