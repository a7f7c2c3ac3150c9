#include "blackboard/server/outbox.hpp"

#include <algorithm>

#include "blackboard/limits.hpp"
#include "blackboard/store/indexing.hpp"
#include "blackboard/store/store.hpp"
#include "lisp/writer.hpp"

namespace pizarra::server {

Outbox::~Outbox() {
  if (flush_timer_ != 0) executor_.cancel(flush_timer_);
}

void Outbox::send(const std::string& peer, const Datum& message) { socket_.send(peer, write(message)); }

void Outbox::reply(const Session& session, const std::string& text) {
  socket_.send(session.peer, session.holds ? with_progress(session, text) : text);
}

// A remembered or held back reply does not carry the permission to send more: it may be given when changes are under
// way anew.
std::string Outbox::with_progress(const Session& session, std::string reply) const {
  reply.back() = ' ';
  write_number_to(reply, board_.store().revision());
  reply += session.watches.are_behind() ? " no)" : " yes)";
  return reply;
}

void Outbox::end_frame() {
  deliver();
  receiving_ = false;
}

// So few wait for each other that none waits long.
void Outbox::owe(const std::string& peer, const std::string& reply) {
  constexpr int most_together = 4;
  owed_to_ = peer;
  owed_ += reply;
  if (++owed_replies_ == most_together) deliver();
}

void Outbox::deliver() {
  flush_all();
  if (owed_replies_ == 0) return;
  socket_.send(owed_to_, owed_);
  owed_.clear();
  owed_replies_ = 0;
}

void Outbox::schedule(wire::SessionId id) {
  to_flush_.insert(id);
  if (receiving_ || flush_timer_ != 0) return;
  flush_timer_ = executor_.call_at(executor_.now(), [this] {
    flush_timer_ = 0;
    flush_all();
  });
}

void Outbox::flush_all() {
  for (const wire::SessionId waiting : std::exchange(to_flush_, {})) flush(waiting);
}

void Outbox::flush(wire::SessionId id) {
  Session* const session = sessions_.find(id);
  if (session != nullptr && send_changes(id, *session)) workload_.wait(session->client(), id);
}

// Whether there is more to be looked for, in a turn.
bool Outbox::send_changes(wire::SessionId id, Session& session) {
  const bool rests = workload_.is_resting() || awaits_index(session);
  const std::size_t before = rests ? std::max(workload_.examined(), limits::examined_a_turn) : workload_.examined();
  const store::Indexing indexing(store::Indexing::May::make_in_parts, &board_.store().index_maker());
  std::size_t examined = before;
  const bool more = session.watches.send(socket_, session.peer, examined);
  workload_.spend(examined - before);
  workload_.took(id, examined - before + indexing.examined());
  if (indexing.awaited() != 0) session.awaited = indexing.awaited();
  return more && !awaits_index(session);
}

bool Outbox::awaits_index(const Session& session) const {
  return board_.store().index_maker().is_awaited(session.awaited);
}

}  // namespace pizarra::server
