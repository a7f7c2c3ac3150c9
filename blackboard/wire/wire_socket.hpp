#pragma once

// A FrameSocket of ZeroMQ, on the executor.
//
//   WireSocket router(executor, WireSocket::Kind::router,
//                     [&](const std::string& peer, std::optional<std::string_view> frame) { ... });
//   Result<std::string> at = router.bind("tcp://127.0.0.1:*");   // the address that it got
//   if (!router.send(peer, text)) ...                            // it reads too slowly, or is gone
//
// Destroying it removes the files of the ipc addresses that it was bound to.
// A message of more than one frame counts as no frame. One of more than 2 MiB ends its sender's connection. So does one
// of frames without end (endless_watch.hpp); the router's callback is then called without a peer.
//
// With keys it is encrypted: a router's addresses bound with encrypt() in force, and all that a dealer connects to.

#include <string>
#include <vector>
#include <zmq.hpp>

#include "blackboard/wire/doorkeeper.hpp"
#include "blackboard/wire/endless_watch.hpp"
#include "blackboard/wire/frame_socket.hpp"
#include "blackboard/wire/handshake_watch.hpp"
#include "blackboard/wire/keys.hpp"
#include "blackboard/wire/under_way.hpp"

namespace pizarra::wire {

class WireSocket : public FrameSocket {
 public:
  // Frames under way to one peer that does not read, and a router's bytes.
  static constexpr int high_water = 256;
  static constexpr std::size_t most_under_way = 4 << 20;

  // Messages of one peer that wait here while the router serves others. Further ones wait in the network and at the
  // peer.
  static constexpr int read_ahead = 64;
  static constexpr std::int64_t longest_message = 2 << 20;

  WireSocket(Executor& executor, Kind kind, Receiver receiver);
  WireSocket(const WireSocket&) = delete;
  WireSocket& operator=(const WireSocket&) = delete;
  ~WireSocket() override;

  Result<std::string> bind(const std::string& address, const KeyPair* own = nullptr) override;
  void admit(Admit admit) override { doorkeeper_.emplace(executor_, context_, std::move(admit)); }
  Result<void> connect(const std::string& address, const ClientKeys* keys = nullptr,
                       std::optional<Listener> listener = {}) override;
  void connect_again() override;
  void connect_to(const std::string& address) override;
  bool send(const std::string& peer, std::string_view frame) override;
  bool has_room(const std::string& peer) const override { return under_way_.bytes_to(peer) <= most_under_way / 2; }
  const std::string& sender_key() const override { return sender_key_; }
  Time heard_until() override;

 private:
  void end_the_endless();
  void pump();
  void note_look(Time begun, int received);
  bool receive_one();
  void schedule_pump();

  Executor& executor_;
  const Kind kind_;
  Receiver receiver_;
  zmq::context_t context_;
  zmq::socket_t socket_;
  int file_ = -1;
  Executor::TimerId pump_timer_ = 0;
  bool pumping_ = false;
  Time heard_until_{};
  Time round_begun_{};  // in which all is received that has come before
  int received_in_round_ = 0;
  std::vector<std::string> bound_files_;
  UnderWay under_way_;
  bool keyed_ = false;
  std::string sender_key_;
  std::string connected_to_;
  std::optional<HandshakeWatch> handshakes_;
  std::optional<EndlessWatch> endless_;  // of a router
  std::optional<Doorkeeper> doorkeeper_;
};

}  // namespace pizarra::wire
