#include "blackboard/client/remote_watch.hpp"

namespace pizarra {

Task<Result<Change>> RemoteWatch::next() {
  while (unread_.empty() && !ended_) {
    co_await waiters_.wait();
  }
  if (unread_.empty()) co_return fail(*ended_);
  Received first = std::move(unread_.front());
  unread_.pop_front();
  read_up_to(first.sequence, unread_.empty());
  co_return change_of(query(), std::move(first.delta));
}

void RemoteWatch::come(std::uint64_t sequence, Delta delta) {
  // A part is read when it is put to the others.
  if (!complete(delta)) return read_up_to(sequence, true);
  unread_.push_back({sequence, std::move(delta)});
  waiters_.wake_all();
}

bool RemoteWatch::complete(Delta& delta) {
  if (delta.kind == Delta::Kind::change || delta.kind == Delta::Kind::all) return true;
  if (delta.kind == Delta::Kind::first_part) parts_.clear();
  for (const Fact& fact : delta.removed.facts) parts_.erase(fact.id);
  for (Fact& fact : delta.added.facts) {
    const FactId id = fact.id;
    parts_.emplace(id, std::move(fact));
  }
  if (delta.kind != Delta::Kind::last_part) return false;
  delta.added = {parts_.size(), {}};
  delta.removed = {};
  for (auto& [id, fact] : parts_) delta.added.facts.push_back(std::move(fact));
  parts_.clear();
  return true;
}

void RemoteWatch::begun_again() {
  for (Received& received : unread_) received.sequence = 0;
}

void RemoteWatch::end(Failure failure) {
  ended_ = std::move(failure);
  waiters_.wake_all();
}

}  // namespace pizarra
