// When a request that came to a BoardServer is let in to the board: behind those of its client that wait, after others
// where its frame had much looked at, when the index is made that it needs, and when its client's turn has come
// (turns.hpp).

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
  if (session.postponed.empty()) wait_for_turn(id, session);
  if (session.postponed.add({message})) return;
  const Failure full{"too-many", "too much waits behind a request that waits for an index, or its turn", {}, {}};
  if (message.is_form("request")) return refuse_undone(session, *wire::count_at(message, 2), message[3], full);
  refuse(session.peer, full);
}

// Now, or when an index is made that it needs, or its turn has come.
void BoardServer::serve(wire::SessionId id, Session& session, wire::RequestId number,
                        const Postponed::Message& waiting) {
  const Datum& message = waiting.datum;
  const Revision before = board_.store().revision();
  if (!answer(id, session, number, waiting)) return session.postponed.wait(waiting);
  const bool timed = message.size() == 5;
  if (timed && board_.store().revision() > before) note_journey(message[3], Time(Duration(message[4].integer())));
}

// Out of its turn it may look at few facts alone. Nothing where it must wait.
std::optional<Result<Datum>> BoardServer::perform_in_turn(wire::SessionId id, Session& session,
                                                          const Postponed::Message& waiting) {
  const bool has_turn = waiting.has_waited() || turns_.is_free(executor_.now());
  const std::size_t before = has_turn ? 0 : limits::examined - Turns::out_of_turn;
  const bool may_wait = has_turn && waiting.may_wait();
  const store::Indexing indexing(may_wait ? store::Indexing::May::make_in_parts : store::Indexing::May::not_make,
                                 &board_.store().index_maker());
  std::size_t examined = before;
  Result<Datum> result = perform(id, session, waiting.datum[3], examined);
  const std::size_t looked_at = examined - before + indexing.examined();
  turns_.took(id, looked_at, executor_.now());
  for_requests_ += looked_at;
  if (indexing.awaited() != 0) {
    session.awaited = indexing.awaited();
    return std::nullopt;
  }
  if (has_turn || result || result.error().symbol != "too-costly") return result;
  wait_for_turn(id, session);
  return std::nullopt;
}

void BoardServer::wait_for_turn(wire::SessionId id, const Session& session) {
  turns_.wait(client_of(session), id);
  schedule_look();
}

}  // namespace pizarra::server
