// When a request that came to a BoardServer is let in to the board: behind those of its client that wait, after others
// where its frame had much looked at, when the index is made that it needs, and when its client's quota allows. What
// each client has looked at is its debt.

#include "blackboard/limits.hpp"
#include "blackboard/server/board_server.hpp"
#include "blackboard/store/indexing.hpp"
#include "blackboard/store/store.hpp"

namespace pizarra::server {

namespace {

// What a client must be able to say at any time to keep what it has.
bool overtakes(const Datum& message) {
  const bool renews = message.is_form("request") && message.size() > 3 && message[3].is_form("renew");
  return renews || message.is_form("ack");
}

}  // namespace

// Behind what waits; or when its frame had so much looked at that others are served before the rest of it.
bool BoardServer::must_wait(const Session& session, const Datum& message) const {
  const bool frame_had_its_turn = for_requests_ - before_frame_ >= limits::examined_a_turn;
  return (frame_had_its_turn || !session.postponed.empty()) && !overtakes(message);
}

void BoardServer::postpone(wire::SessionId id, Session& session, const Datum& message) {
  if (session.postponed.empty()) {
    to_look_.insert(id);
    schedule_look();
  }
  if (session.postponed.add({message})) return;
  const Failure full{"too-many", "too much waits behind a request that waits for an index, or its turn", {}, {}};
  if (message.is_form("request")) return refuse_undone(session, *wire::count_at(message, 2), message[3], full);
  refuse(session.peer, full);
}

// Now, or when an index is made that it needs, or its turn has come.
void BoardServer::serve(wire::SessionId id, Session& session, wire::RequestId number,
                        const Postponed::Message& waiting) {
  const Datum& message = waiting.datum;
  if (!waiting.has_waited()) looks_.asked(id, client_of(session), executor_.now());
  const Revision before = board_.store().revision();
  if (!answer(id, session, number, waiting)) return session.postponed.wait(waiting);
  const bool timed = message.size() == 5;
  if (timed && board_.store().revision() > before) note_journey(message[3], Time(Duration(message[4].integer())));
}

// Whose quota is spent is refused what looks at more than a few facts, and who comes while others owe too much waits
// with that for its turn. Nothing where it must wait.
std::optional<Result<Datum>> BoardServer::perform_within_quota(wire::SessionId id, Session& session,
                                                               const Postponed::Message& waiting) {
  using Standing = LookQuota::Standing;
  const std::string& client = client_of(session);
  const Standing standing = waiting.has_waited() ? Standing::free : looks_.standing(client, executor_.now());
  const bool is_free = standing == Standing::free;
  const std::size_t before = is_free ? 0 : LookQuota::all_but_few;
  const bool may_wait = is_free && waiting.may_wait();
  const store::Indexing indexing(may_wait ? store::Indexing::May::make_in_parts : store::Indexing::May::not_make,
                                 client, &board_.store().index_maker());
  std::size_t examined = before;
  Result<Datum> result = perform(id, session, waiting.datum[3], examined);
  const std::size_t looked_at = examined - before + indexing.examined();
  looks_.looked(client, looked_at, executor_.now());
  for_requests_ += looked_at;
  if (indexing.awaited() != 0) {
    session.awaited = indexing.awaited();
    return std::nullopt;
  }
  if (is_free || result || result.error().symbol != "too-costly") return result;
  if (standing == Standing::waits) {
    wait_for_turn(id, session);
    return std::nullopt;
  }
  board_.statistics().requests().refuse(client, executor_.now());
  return LookQuota::refusal(client);
}

void BoardServer::wait_for_turn(wire::SessionId id, Session& session) {
  session.awaits_turn = true;
  to_look_.insert(id);
  schedule_look();
}

}  // namespace pizarra::server
