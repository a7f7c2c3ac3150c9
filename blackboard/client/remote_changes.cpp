#include "blackboard/client/remote_changes.hpp"

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

}  // namespace pizarra::client
