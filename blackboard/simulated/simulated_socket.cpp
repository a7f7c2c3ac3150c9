#include "blackboard/simulated/simulated_socket.hpp"

#include <cassert>

namespace pizarra::simulated {

SimulatedSocket::SimulatedSocket(Network& network, std::string name, Process& process, Kind kind, Receiver receiver)
    : network_(network),
      name_(std::move(name)),
      process_(process),
      kind_(kind),
      receiver_(std::move(receiver)),
      number_(network.next_++) {
  network_.open(*this);
}

SimulatedSocket::~SimulatedSocket() {
  network_.close(*this);
  for (const Executor::TimerId delivery : deliveries_) process_.cancel(delivery);
}

Result<std::string> SimulatedSocket::bind(const std::string& address, [[maybe_unused]] const wire::KeyPair* own) {
  assert(own == nullptr && "the simulated network has no keys");
  return network_.bind(*this, address);
}

void SimulatedSocket::admit(Admit) { assert(false && "the simulated network has no keys"); }

Result<void> SimulatedSocket::connect(const std::string& address, [[maybe_unused]] const wire::ClientKeys* keys,
                                      std::optional<Listener> listener) {
  assert(keys == nullptr && "the simulated network has no keys");
  address_ = address;
  if (listener) listener_ = std::move(*listener);
  network_.connect_soon(*this, Duration::zero());
  return {};
}

void SimulatedSocket::connect_again() { network_.connect_soon(*this, Duration::zero()); }

void SimulatedSocket::connect_to(const std::string& address) {
  address_ = address;
  network_.close(*this);
  connect_again();
}

bool SimulatedSocket::send(const std::string& peer, std::string_view frame) {
  return !cut_off_ && network_.send(*this, peer, frame);
}

bool SimulatedSocket::has_room(const std::string& peer) const { return network_.has_room(*this, peer); }

Time SimulatedSocket::heard_until() {
  // What came at that very time waits still.
  return unheard_.empty() ? process_.now() : unheard_.front() - Duration(1);
}

void SimulatedSocket::take(const std::string& peer, std::string frame) {
  unheard_.push_back(process_.now());
  const auto delivery = std::make_shared<Executor::TimerId>(0);
  *delivery = process_.call_at(process_.now(), [this, peer, frame = std::move(frame), delivery] {
    deliveries_.erase(*delivery);
    unheard_.pop_front();
    receiver_(peer, frame);
  });
  deliveries_.insert(*delivery);
}

void SimulatedSocket::hear_connected() {
  if (!listener_.let_in) return;
  const auto hearing = std::make_shared<Executor::TimerId>(0);
  *hearing = process_.call_at(process_.now(), [this, hearing] {
    deliveries_.erase(*hearing);
    listener_.let_in();
  });
  deliveries_.insert(*hearing);
}

}  // namespace pizarra::simulated
