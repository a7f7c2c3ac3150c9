#pragma once

// A network in virtual time that carries the frames of boards and their clients as ZeroMQ does: in order on a
// connection, bounded, and lost with it. It delays each frame, and it fails on demand.
//
//   Network network(time, Random(seed), {.least = 50us, .most = 400us});
//   const std::unique_ptr<wire::Transport> wires = network.plug("vision", process);
//   client::RemoteBoard::connect(process, "tcp://127.0.0.1:1", "vision", 5s, {}, *wires);
//   network.break_connections("vision");          // what is under way is lost; the client connects again
//   network.lose_next_reply("vision");            // with its connection, after the board has sent it
//   network.stall("vision", 3s);                  // nothing arrives meanwhile, and then all of it, in order
//   network.unplug("vision");                     // its process has ended: nobody hears of it but that it is gone
//
// It outlives the sockets that were opened on it. A plug outlives the sockets that it opened.

#include <map>
#include <memory>
#include <string>

#include "blackboard/time/random.hpp"
#include "blackboard/wire/frame_socket.hpp"

namespace pizarra::simulated {

class Process;
class SimulatedSocket;

class Network {
 public:
  // Of each frame; more than that differs from connection to connection, so that agents overtake each other.
  struct Delay {
    Duration least = 50us;
    Duration most = 400us;
  };
  static constexpr std::size_t most_under_way = 256;            // frames of a connection, one way
  static constexpr std::size_t most_bytes_under_way = 4 << 20;  // and bytes
  static constexpr Duration connect_again_after = 60ms;

  Network(Executor& time, Random random, Delay delay);
  Network(const Network&) = delete;
  Network& operator=(const Network&) = delete;
  ~Network();

  std::unique_ptr<wire::Transport> plug(std::string name, Process& process);
  void unplug(const std::string& name);

  void set_delay(Delay delay) { delay_ = delay; }
  void break_connections(const std::string& name);
  void lose_next_reply(const std::string& name);
  void stall(const std::string& name, Duration length);
  // Frames of a connection overtake each other, as no transport may let them.
  void let_frames_overtake(bool overtake) { overtake_ = overtake; }

  struct Counts {
    std::uint64_t frames = 0;
    std::uint64_t lost = 0;
    std::uint64_t lost_replies = 0;
    std::uint64_t connections = 0;
  };
  const Counts& counts() const { return counts_; }

 private:
  friend class SimulatedSocket;
  struct Connection;
  struct Direction;

  void open(SimulatedSocket& socket);
  void close(SimulatedSocket& socket);
  Result<std::string> bind(SimulatedSocket& socket, const std::string& address);
  void connect_soon(SimulatedSocket& dealer, Duration after);
  void connect(SimulatedSocket& dealer);
  bool send(SimulatedSocket& from, const std::string& peer, std::string_view frame);
  bool has_room(const SimulatedSocket& from, const std::string& peer) const;
  void arrive(const std::shared_ptr<Connection>& connection, bool to_router);
  void cut(const std::shared_ptr<Connection>& connection);
  Duration draw_delay();

  Executor& time_;
  Random random_;
  Delay delay_;
  Counts counts_;
  bool overtake_ = false;
  std::map<std::string, SimulatedSocket*> routers_;                           // by address
  std::map<std::string, std::map<std::uint64_t, SimulatedSocket*>> dealers_;  // by the name of their process
  std::map<std::string, std::shared_ptr<Connection>> connections_;  // by the name that the router knows them by
  std::map<std::string, Time> stalled_;
  std::uint64_t next_ = 1;
};

}  // namespace pizarra::simulated
