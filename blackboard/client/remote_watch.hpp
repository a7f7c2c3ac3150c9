#pragma once

// The watched queries of a RemoteBoard. RemoteChanges is what each has: the changes from the server, numbered from 1
// and acknowledged as they are read. It begins again, under a new number, when one is missing or the server was lost.
//
// RemoteWatch is a watch that is read: what comes waits for next(). Where an answer is one fact, what holds is kept, so
// that the server need not say again what it was that went. Replica (replicas.hpp) answers questions instead.
//
// Lifecycle: made beside the board, which outlives it, and its request() is sent once. From then on the board hands it
// what comes, and begins it again after a loss, until it is destroyed or end() is called.
//
//   Result<std::unique_ptr<Watch>> watch = co_await board.watch(query);   // a RemoteWatch
//   Result<Change> change = co_await (*watch)->next();

#include <deque>

#include "blackboard/client/remote_board.hpp"
#include "blackboard/delta.hpp"
#include "blackboard/store/fact_list.hpp"
#include "blackboard/time/latch.hpp"

namespace pizarra::client {

class RemoteChanges {
 public:
  // `held`: questions are answered from it, so that the server's replies must say how far it has come.
  RemoteChanges(RemoteBoard& board, Query query, bool held);
  RemoteChanges(const RemoteChanges&) = delete;
  RemoteChanges& operator=(const RemoteChanges&) = delete;
  virtual ~RemoteChanges();

  // The request for it.
  Datum request() const;
  // Asks under a new number, so that nothing said about the former one is mistaken for it.
  void begin_again();
  void receive(std::uint64_t sequence, const Datum& message);
  // Says again what was read, if that could not be said before.
  void acknowledge();
  // Nothing more will come.
  virtual void end(Failure failure) = 0;

 protected:
  static constexpr std::uint64_t acknowledge_after = 8;

  const Query& query() const { return query_; }
  RemoteBoard& board() { return board_; }
  // What came is kept or made use of; read_up_to() then says so. For a query whose answers are one fact, only the ids
  // of removed facts are known.
  virtual void come(std::uint64_t sequence, Delta delta) = 0;
  virtual bool has_room() const = 0;
  virtual bool has_ended() const = 0;
  // Numbers begin with 1 again.
  virtual void begun_again() = 0;
  void read_up_to(std::uint64_t sequence, bool say_so);

 private:
  void enrol();
  void note_arrival(const Delta& delta);

  RemoteBoard& board_;
  const Query query_;
  const bool held_;
  wire::WatchId id_ = 0;
  wire::RequestId request_ = 0;
  std::uint64_t expected_ = 1;
  std::uint64_t read_ = 0;
  std::uint64_t acknowledged_ = 0;
  struct Arrival {
    std::string relation;
    Duration took;
  };
  std::optional<Arrival> arrival_;  // of a fact, not told to the server yet
};

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
