#include "blackboard/client/remote_watch.hpp"

#include "blackboard/wire/answer_form.hpp"
#include "lisp/writer.hpp"

namespace pizarra::client {

RemoteChanges::RemoteChanges(RemoteBoard& board, Query query, bool held)
    : board_(board), query_(std::move(query)), held_(held) {
  enrol();
}

RemoteChanges::~RemoteChanges() {
  board_.streams_.erase(id_);
  board_.session_.forget(request_);
  board_.session_.send(list("unwatch"_sym, board_.session_.id(), id_));
}

Datum RemoteChanges::request() const {
  if (held_) return list("watch"_sym, id_, query_to_datum(query_), "held"_sym);
  if (width_of(query_) == 1) return list("watch"_sym, id_, query_to_datum(query_), "kept"_sym);
  return list("watch"_sym, id_, query_to_datum(query_));
}

void RemoteChanges::enrol() {
  id_ = board_.next_watch_++;
  board_.streams_.emplace(id_, this);
}

void RemoteChanges::begin_again() {
  if (has_ended()) return;
  board_.streams_.erase(id_);
  board_.session_.forget(request_);
  board_.session_.send(list("unwatch"_sym, board_.session_.id(), id_));
  enrol();
  expected_ = 1;
  read_ = 0;
  acknowledged_ = 0;
  begun_again();
  request_ = board_.session_.begin(write(request()), [this](const Result<Datum>& reply) {
    request_ = 0;
    if (!reply) end(reply.error());
  });
}

void RemoteChanges::receive(std::uint64_t sequence, const Datum& message) {
  Result<Delta> delta = wire::delta_from_datum(query_, held_ || width_of(query_) == 1, message);
  if (!delta) return end(delta.error());
  if (sequence < expected_) return;
  const bool from_the_start = delta->kind == Delta::Kind::all || delta->kind == Delta::Kind::first_part;
  const bool gap = sequence > expected_ && !from_the_start;
  if (gap || !has_room()) return begin_again();
  expected_ = sequence + 1;
  note_arrival(*delta);
  come(sequence, std::move(*delta));
}

void RemoteChanges::note_arrival(const Delta& delta) {
  const Time here = board_.executor_.now();
  if (delta.kind != Delta::Kind::change || here - board_.arrival_timed_ < RemoteRequests::between_timed) return;
  const std::optional<Time> now = board_.session_.board_clock().there(here);
  for (const Fact& fact : delta.added.facts) {
    if (!now || fact.revision != delta.revision) continue;
    arrival_ = Arrival{std::string(fact.datum.head()), *now - fact.when};
    board_.arrival_timed_ = here;
    return;
  }
}

void RemoteChanges::read_up_to(std::uint64_t sequence, bool say_so) {
  // Frames received under a former number need no acknowledgement any more.
  if (sequence > read_ && sequence < expected_) read_ = sequence;
  // Where changes come one by one, an acknowledgement of each would wake the server as often as the changes do.
  if (say_so || arrival_ || read_ - acknowledged_ >= acknowledge_after) acknowledge();
}

void RemoteChanges::acknowledge() {
  if (read_ == acknowledged_) return;
  Datum ack = list("ack"_sym, board_.session_.id(), id_, read_);
  if (arrival_) ack = list(ack[0], ack[1], ack[2], ack[3], Datum::symbol(arrival_->relation), arrival_->took.count());
  if (!board_.session_.send(ack)) return;
  acknowledged_ = read_;
  arrival_.reset();
}

Task<Result<Change>> RemoteWatch::next() {
  while (unread_.empty() && !ended_) {
    co_await waiters_.wait();
  }
  if (unread_.empty()) co_return fail(*ended_);
  Received first = std::move(unread_.front());
  unread_.pop_front();
  read_up_to(first.sequence, false);
  co_return answering_.change(std::move(first.delta));
}

void RemoteWatch::come(std::uint64_t sequence, Delta delta) {
  const bool last = delta.kind != Delta::Kind::first_part && delta.kind != Delta::Kind::part;
  if (width_of(query()) == 1 && !keep(delta)) return begin_again();
  // A part is read when it is put to the others.
  if (!last) return read_up_to(sequence, true);
  unread_.push_back({sequence, std::move(delta)});
  waiters_.wake_all();
}

bool RemoteWatch::keep(Delta& delta) {
  if (delta.kind == Delta::Kind::all || delta.kind == Delta::Kind::first_part) kept_.emplace();
  if (!kept_) return false;
  for (Fact& fact : delta.removed.facts) {
    store::StandingFact* gone = kept_->find(fact.id);
    if (gone == nullptr) return false;
    fact = kept_->remove(*gone).fact;
  }
  for (const Fact& fact : delta.added.facts) {
    if (kept_->find(fact.id) != nullptr) return false;
    kept_->insert({fact});
  }
  // With the last part the whole is known.
  if (delta.kind != Delta::Kind::last_part) return true;
  delta.added = {kept_->size(), {}};
  delta.removed = {};
  for (const store::StandingFact& standing : kept_->from(0)) delta.added.facts.push_back(standing.fact);
  return true;
}

void RemoteWatch::begun_again() {
  for (Received& received : unread_) received.sequence = 0;
  kept_.reset();
}

void RemoteWatch::end(Failure failure) {
  ended_ = std::move(failure);
  waiters_.wake_all();
}

}  // namespace pizarra::client
