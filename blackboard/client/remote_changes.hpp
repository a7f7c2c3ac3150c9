#pragma once

// The order of a watched query's changes: they come from the server numbered from 1, and are acknowledged as they are
// read. Where one is missing, or the server was lost, the query is watched anew under a new number.
//
// Lifecycle: made beside the board, which outlives it, and its request() is sent once. From then on the board hands it
// what comes, and begins it again after a loss, until it is destroyed or end() is called. RemoteWatch
// (remote_watch.hpp) and Replica (replicas.hpp) are made of it, and say what a change does.

#include "blackboard/client/remote_board.hpp"
#include "blackboard/delta.hpp"

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

}  // namespace pizarra::client
