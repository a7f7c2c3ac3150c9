// What takes a BoardServer long goes on in turns, between which it hears others: an index is made, what holds of
// watches is looked for, and what waited for these is done.

#include <algorithm>

#include "blackboard/limits.hpp"
#include "blackboard/server/board_server.hpp"
#include "blackboard/store/indexing.hpp"
#include "blackboard/store/store.hpp"

namespace pizarra::server {

namespace {

constexpr Duration until_paid = 1ms;
// Of a request, to do what it says.
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
  if (found == sessions_.end() || !send_changes(found->second)) return;
  to_look_.insert(id);
  schedule_look();
}

// Whether there is more to be looked for, now or when what the client owes is paid.
bool BoardServer::send_changes(Session& session) {
  const std::string& client = client_of(session);
  const bool rests = !has_turn(session) || awaits_index(session);
  const std::size_t before = rests ? std::max(examined_, limits::examined_a_turn) : examined_;
  const store::Indexing indexing(store::Indexing::May::make_in_parts, client, &board_.store().index_maker());
  std::size_t examined = before;
  const bool more = session.watches.send(socket_, session.peer, examined);
  examined_ += examined - before;
  const std::size_t looked_at = examined - before + indexing.examined();
  if (looked_at > 0) looks_.looked(client, looked_at, executor_.now());
  if (indexing.awaited() != 0) session.awaited = indexing.awaited();
  return more && !awaits_index(session);
}

void BoardServer::schedule_look() {
  if (look_timer_ != 0) return;
  // Not at once: what is due at once is done several times before anybody is heard.
  const bool busy = examined_ > 0 || for_requests_ > before_frame_ || !board_.store().index_maker().is_idle();
  const Duration pause = busy ? 1us : until_paid;
  look_timer_ = executor_.call_at(executor_.now() + pause, [this] { look_on(); });
}

// Each in its turn.
void BoardServer::look_on() {
  examined_ = 0;
  before_frame_ = for_requests_;
  if (!board_.store().index_maker().is_idle()) make_on();
  for (std::size_t left = to_look_.size(); left > 0 && examined_ < limits::examined_a_turn; --left) {
    auto next = to_look_.upper_bound(looked_last_);
    if (next == to_look_.end()) next = to_look_.begin();
    looked_last_ = *next;
    to_look_.erase(next);
    go_on(looked_last_);
    flush(looked_last_);
  }
  look_timer_ = 0;
  if (!to_look_.empty() || !board_.store().index_maker().is_idle()) schedule_look();
}

bool BoardServer::awaits_index(const Session& session) const {
  return board_.store().index_maker().is_under_way(session.awaited);
}

void BoardServer::make_on() {
  looks_.pay(executor_.now());
  const store::IndexMaker::Part part = board_.store().index_maker().make_some();
  looks_.looked(part.client, part.examined, executor_.now());
  if (part.made == 0) return;
  for (const auto& [id, session] : sessions_) {
    if (session.awaited == part.made) to_look_.insert(id);
  }
}

// With the messages that were postponed, as many as the turn has room for.
void BoardServer::go_on(wire::SessionId id) {
  while (true) {
    const auto found = sessions_.find(id);
    if (found == sessions_.end() || found->second.postponed.empty() || awaits_index(found->second)) return;
    Session& session = found->second;
    session.awaits_turn = session.awaits_turn && !has_turn(session);
    if (session.awaits_turn || examined_ >= limits::examined_a_turn) break;
    const Postponed::Message next = session.postponed.next();
    const std::size_t before = for_requests_;
    // As much as nobody counts of a request.
    examined_ += LookQuota::uncounted + weigh(next.datum).bytes / bytes_a_look;
    hear(id, session, next);
    examined_ += for_requests_ - before;
  }
  to_look_.insert(id);
}

bool BoardServer::has_turn(const Session& session) {
  return looks_.standing(client_of(session), executor_.now()) == LookQuota::Standing::free;
}

}  // namespace pizarra::server
