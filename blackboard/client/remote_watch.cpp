#include "blackboard/client/remote_watch.hpp"

namespace pizarra::client {

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
