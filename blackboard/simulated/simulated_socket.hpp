#pragma once

// A FrameSocket of a simulated Network, on the executor of its process.
//
// Lifecycle: the transport that a Network gives to a process opens it, and both outlive it. What comes while the
// process is held up waits. When the process has ended, nothing comes any more.
//
//   SimulatedSocket socket(network, "arm-pc", process, Kind::dealer, receiver);
//   socket.connect("tcp://board-pc:7800", nullptr, {});

#include <deque>
#include <set>

#include "blackboard/simulated/network.hpp"
#include "blackboard/simulated/process.hpp"

namespace pizarra::simulated {

class SimulatedSocket : public wire::FrameSocket {
 public:
  SimulatedSocket(Network& network, std::string name, Process& process, Kind kind, Receiver receiver);
  SimulatedSocket(const SimulatedSocket&) = delete;
  SimulatedSocket& operator=(const SimulatedSocket&) = delete;
  ~SimulatedSocket() override;

  Result<std::string> bind(const std::string& address, const wire::KeyPair* own) override;
  void admit(Admit admit) override;
  Result<void> connect(const std::string& address, const wire::ClientKeys* keys,
                       std::optional<Listener> listener) override;
  void connect_again() override;
  void connect_to(const std::string& address) override;
  bool send(const std::string& peer, std::string_view frame) override;
  bool has_room(const std::string& peer) const override;
  const std::string& sender_key() const override { return nobodys_key_; }
  Time heard_until() override;

 private:
  friend class Network;
  // Takes a frame that has come to its process, which may be held up.
  void take(const std::string& peer, std::string frame);
  void hear_connected();

  Network& network_;
  const std::string name_;
  Process& process_;
  const Kind kind_;
  const Receiver receiver_;
  Listener listener_;
  const std::uint64_t number_;
  std::string address_;
  std::string connection_;    // of a dealer; empty: none stands
  std::deque<Time> unheard_;  // when each that waits here came, by its own clock
  std::set<Executor::TimerId> deliveries_;
  const std::string nobodys_key_;
  bool cut_off_ = false;  // its process has ended
};

}  // namespace pizarra::simulated
