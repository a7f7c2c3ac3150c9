#pragma once

// A watch of a RemoteBoard that is read: what comes waits for next(). Where an answer is one fact, what holds is kept,
// so that the server need not say again what it was that went.
//
//   Result<std::unique_ptr<Watch>> watch = co_await board.watch(query);   // a RemoteWatch
//   Result<Change> change = co_await (*watch)->next();

#include <deque>

#include "blackboard/client/remote_changes.hpp"
#include "blackboard/store/fact_list.hpp"
#include "blackboard/time/latch.hpp"

namespace pizarra::client {

class RemoteWatch : public Watch, public RemoteChanges {
 public:
  RemoteWatch(RemoteBoard& board, Executor& executor, Query query)
      : RemoteChanges(board, std::move(query), false), answering_(this->query()), waiters_(executor) {}

  Task<Result<Change>> next() override;
  void end(Failure failure) override;

 private:
  static constexpr std::size_t max_unread = 64;  // more than a server sends unacknowledged

  void come(std::uint64_t sequence, Delta delta) override;
  bool has_room() const override { return unread_.size() < max_unread; }
  bool has_ended() const override { return ended_.has_value(); }
  void begun_again() override;
  // Brings what is kept up to date, and the delta to what it says of it; false where that does not fit together.
  bool keep(Delta& delta);

  struct Received {
    std::uint64_t sequence;
    Delta delta;
  };
  const Answering answering_;
  std::deque<Received> unread_;
  std::optional<store::FactList> kept_;
  std::optional<Failure> ended_;
  WaitList waiters_;
};

}  // namespace pizarra::client
