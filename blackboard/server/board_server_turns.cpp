// A BoardServer does long work in turns (turns.hpp), and hears others between them: a costly request is done, an index
// is made, what holds of watches is looked for, and what waited for these.

#include <algorithm>

#include "blackboard/limits.hpp"
#include "blackboard/server/board_server.hpp"
#include "blackboard/store/indexing.hpp"
#include "blackboard/store/store.hpp"

namespace pizarra::server {

namespace {

// What a message takes whatever it asks for.
constexpr std::size_t looks_a_message = 64;
constexpr std::size_t bytes_a_look = 64;

// Messages that a client must be able to send at any time to keep what it has.
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
  const std::size_t before = has_turn ? 0 : limits::examined - CostlyTurns::out_of_turn;
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
  turns_.wait(session.client(), id);
  schedule_look();
}

void BoardServer::schedule_flush(wire::SessionId id) {
  to_flush_.insert(id);
  if (receiving_ || flush_timer_ != 0) return;
  flush_timer_ = executor_.call_at(executor_.now(), [this] {
    flush_timer_ = 0;
    flush_all();
  });
}

void BoardServer::flush_all() {
  for (const wire::SessionId waiting : std::exchange(to_flush_, {})) flush(waiting);
}

void BoardServer::flush(wire::SessionId id) {
  Session* const session = sessions_.find(id);
  if (session != nullptr && send_changes(id, *session)) wait_for_turn(id, *session);
}

// Whether there is more to be looked for, in a turn.
bool BoardServer::send_changes(wire::SessionId id, Session& session) {
  const bool rests = turns_.is_resting(executor_.now()) || awaits_index(session);
  const std::size_t before = rests ? std::max(examined_, limits::examined_a_turn) : examined_;
  const store::Indexing indexing(store::Indexing::May::make_in_parts, &board_.store().index_maker());
  std::size_t examined = before;
  const bool more = session.watches.send(*socket_, session.peer, examined);
  examined_ += examined - before;
  turns_.took(id, examined - before + indexing.examined(), executor_.now());
  if (indexing.awaited() != 0) session.awaited = indexing.awaited();
  return more && !awaits_index(session);
}

void BoardServer::schedule_look() {
  if (look_timer_ != 0) return;
  // Not at once: what is due at once is done several times before anybody is heard.
  const Time soon = executor_.now() + 1us;
  look_timer_ = executor_.call_at(turns_.is_resting(soon) ? turns_.rested() : soon, [this] {
    look_timer_ = 0;
    look_on();
  });
}

// Each client in its turn.
void BoardServer::look_on() {
  if (turns_.is_resting(executor_.now())) return schedule_look();
  examined_ = 0;
  before_frame_ = for_requests_;
  if (!board_.store().index_maker().is_idle()) make_on();
  for (std::size_t left = turns_.clients(); left > 0 && examined_ < limits::examined_a_turn; --left) {
    const wire::SessionId id = turns_.next();
    go_on(id);
    flush(id);
  }
  if (!turns_.empty() || !board_.store().index_maker().is_idle()) schedule_look();
}

bool BoardServer::awaits_index(const Session& session) const {
  return board_.store().index_maker().is_awaited(session.awaited);
}

// Requests that await any index look again for their own when one is made.
void BoardServer::make_on() {
  store::IndexMaker& maker = board_.store().index_maker();
  constexpr wire::SessionId nobody = 0;
  const std::uint64_t made = maker.made();
  turns_.took(nobody, maker.make_some(), executor_.now());
  if (maker.made() == made) return;
  for (const auto& [id, session] : sessions_.all()) {
    if (session.awaited != 0 && !maker.is_awaited(session.awaited)) wait_for_turn(id, session);
  }
}

// With the messages that were postponed, as many as the turn has room for.
void BoardServer::go_on(wire::SessionId id) {
  while (true) {
    Session* const session = sessions_.find(id);
    if (session == nullptr || session->postponed.empty() || awaits_index(*session)) return;
    if (examined_ >= limits::examined_a_turn) return wait_for_turn(id, *session);
    const Postponed::Message next = session->postponed.next();
    const std::size_t before = for_requests_;
    examined_ += looks_a_message + weigh(next.datum).bytes / bytes_a_look;
    hear(id, *session, next);
    examined_ += for_requests_ - before;
  }
}

}  // namespace pizarra::server
