#pragma once

// One watch of a RemoteBoard: receives numbered changes, acknowledges them as they are read, and begins again when one
// is missing or the server was lost.

#include <deque>

#include "blackboard/remote_board.hpp"
#include "blackboard/time/event.hpp"

namespace pizarra {

class RemoteWatch : public Watch {
 public:
  RemoteWatch(RemoteBoard& board, Query query);
  RemoteWatch(const RemoteWatch&) = delete;
  RemoteWatch& operator=(const RemoteWatch&) = delete;
  ~RemoteWatch() override;

  Task<Result<Change>> next() override;

  // What asks the server for it.
  Datum request() const;
  // Asks under a new number, so that nothing said about the former one is mistaken for it.
  void begin_again();
  void receive(std::uint64_t sequence, const Datum& message);
  void end(Failure failure);
  // Says again what was read, if that could not be said before.
  void acknowledge_owed();

 private:
  static constexpr std::size_t max_unread = 64;  // more than a server sends unacknowledged
  static constexpr std::uint64_t acknowledge_after = 8;

  void enrol();
  void acknowledge();
  // What holds comes in parts: nothing until the last has come.
  std::optional<Change> assemble(wire::ReceivedChange received);

  struct Received {
    std::uint64_t sequence;
    Change change;
  };
  RemoteBoard& board_;
  const Query query_;
  wire::WatchId id_ = 0;
  wire::RequestId request_ = 0;
  std::uint64_t expected_ = 1;
  std::uint64_t read_ = 0;
  std::uint64_t acknowledged_ = 0;
  std::deque<Received> unread_;
  std::map<FactId, Answer> parts_;
  std::optional<Failure> ended_;
  WaitList waiters_;
};

}  // namespace pizarra
