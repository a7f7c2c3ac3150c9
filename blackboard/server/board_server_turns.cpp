// What takes a BoardServer long goes on in turns, between which it hears others: an index is made, what holds of
// watches is looked for, and what waited for these is done.

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

}  // namespace

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
  const auto found = sessions_.find(id);
  if (found != sessions_.end() && send_changes(id, found->second)) wait_for_turn(id, found->second);
}

// Whether there is more to be looked for, in a turn.
bool BoardServer::send_changes(wire::SessionId id, Session& session) {
  const bool rests = turns_.is_resting(executor_.now()) || awaits_index(session);
  const std::size_t before = rests ? std::max(examined_, limits::examined_a_turn) : examined_;
  const store::Indexing indexing(store::Indexing::May::make_in_parts, &board_.store().index_maker());
  std::size_t examined = before;
  const bool more = session.watches.send(socket_, session.peer, examined);
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

// Who awaits any index looks again for its own when one is made.
void BoardServer::make_on() {
  store::IndexMaker& maker = board_.store().index_maker();
  constexpr wire::SessionId nobody = 0;
  const std::uint64_t made = maker.made();
  turns_.took(nobody, maker.make_some(), executor_.now());
  if (maker.made() == made) return;
  for (const auto& [id, session] : sessions_) {
    if (session.awaited != 0 && !maker.is_awaited(session.awaited)) wait_for_turn(id, session);
  }
}

// With the messages that were postponed, as many as the turn has room for.
void BoardServer::go_on(wire::SessionId id) {
  while (true) {
    const auto found = sessions_.find(id);
    if (found == sessions_.end() || found->second.postponed.empty() || awaits_index(found->second)) return;
    Session& session = found->second;
    if (examined_ >= limits::examined_a_turn) return wait_for_turn(id, session);
    const Postponed::Message next = session.postponed.next();
    const std::size_t before = for_requests_;
    examined_ += looks_a_message + weigh(next.datum).bytes / bytes_a_look;
    hear(id, session, next);
    examined_ += for_requests_ - before;
  }
}

}  // namespace pizarra::server
