#include "blackboard/remote_watch.hpp"

namespace pizarra {

RemoteWatch::RemoteWatch(RemoteBoard& board, Query query)
    : board_(board), query_(std::move(query)), waiters_(board.executor_) {
  enrol();
}

RemoteWatch::~RemoteWatch() {
  board_.watches_.erase(id_);
  board_.forget(request_);
  board_.send(list("unwatch"_sym, board_.session_, id_));
}

Task<Result<Change>> RemoteWatch::next() {
  while (unread_.empty() && !ended_) {
    co_await waiters_.wait();
  }
  if (unread_.empty()) co_return fail(*ended_);
  Received first = std::move(unread_.front());
  unread_.pop_front();
  // What was received under a former number needs no acknowledgement any more.
  if (first.sequence > read_ && first.sequence < expected_) read_ = first.sequence;
  if (unread_.empty() || read_ - acknowledged_ >= acknowledge_after) acknowledge();
  co_return std::move(first.change);
}

Datum RemoteWatch::request() const { return list("watch"_sym, id_, query_to_datum(query_)); }

void RemoteWatch::enrol() {
  id_ = board_.next_watch_++;
  board_.watches_.emplace(id_, this);
}

void RemoteWatch::begin_again() {
  if (ended_) return;
  board_.watches_.erase(id_);
  board_.forget(request_);
  board_.send(list("unwatch"_sym, board_.session_, id_));
  enrol();
  expected_ = 1;
  read_ = 0;
  acknowledged_ = 0;
  for (Received& received : unread_) received.sequence = 0;
  request_ = board_.begin(request(), true, [this](const Result<Datum>& reply) {
    request_ = 0;
    if (!reply) end(reply.error());
  });
}

void RemoteWatch::receive(std::uint64_t sequence, const Datum& message) {
  Result<wire::ReceivedChange> received = wire::change_from_datum(query_, message);
  if (!received) return end(received.error());
  if (sequence < expected_) return;
  const bool whole = received->kind == Delta::Kind::all || received->kind == Delta::Kind::first_part;
  const bool gap = sequence > expected_ && !whole;
  if (gap || unread_.size() >= max_unread) return begin_again();
  expected_ = sequence + 1;
  std::optional<Change> change = assemble(std::move(*received));
  if (change) {
    unread_.push_back({sequence, std::move(*change)});
    waiters_.wake_all();
  } else {
    // A part is read when it is put to the others.
    read_ = sequence;
    acknowledge();
  }
}

std::optional<Change> RemoteWatch::assemble(wire::ReceivedChange received) {
  Change& change = received.change;
  if (received.kind == Delta::Kind::change || received.kind == Delta::Kind::all) return std::move(change);
  if (received.kind == Delta::Kind::first_part) parts_.clear();
  for (const Answer& answer : change.removed) parts_.erase(answer.facts.front().id);
  for (Answer& answer : change.added) parts_.emplace(answer.facts.front().id, std::move(answer));
  if (received.kind != Delta::Kind::last_part) return std::nullopt;
  change.added.clear();
  change.removed.clear();
  for (auto& [id, answer] : parts_) change.added.push_back(std::move(answer));
  parts_.clear();
  return std::move(change);
}

void RemoteWatch::end(Failure failure) {
  ended_ = std::move(failure);
  waiters_.wake_all();
}

void RemoteWatch::acknowledge() {
  if (read_ == acknowledged_) return;
  if (board_.send(list("ack"_sym, board_.session_, id_, read_))) acknowledged_ = read_;
}

void RemoteWatch::acknowledge_owed() {
  if (unread_.empty()) acknowledge();
}

}  // namespace pizarra
