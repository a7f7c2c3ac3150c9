#pragma once

// The stream of one watched query from a server: changes, numbered from 1, acknowledged as they are read. It begins
// again, under a new number, when one is missing or the server was lost.
//
// Lifecycle: a derived class is made beside the board, which outlives it, and its request() is sent once. From then on
// the board hands it what comes, and begins it again after a loss, until it is destroyed or end() is called.
//
//   void Copy::come(std::uint64_t sequence, Delta delta) {     // of a class Copy : public RemoteStream
//     take(std::move(delta));
//     read_up_to(sequence, true);
//   }

#include "blackboard/client/remote_board.hpp"
#include "blackboard/delta.hpp"

namespace pizarra::client {

class RemoteStream {
 public:
  // `held`: questions are answered from it, so that the server's replies must say how far it has come.
  RemoteStream(RemoteBoard& board, Query query, bool held);
  RemoteStream(const RemoteStream&) = delete;
  RemoteStream& operator=(const RemoteStream&) = delete;
  virtual ~RemoteStream();

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
