#pragma once

// What ZeroMQ does alone: a router in a process of its own that answers, and forwards to whoever said `watch`.
//
//   RawRouter router;
//   RawDealer teller(router.address());
//   teller.send(payload);
//   teller.receive();

#include <string>
#include <zmq.hpp>

#include "tests/bench/child.hpp"

namespace pizarra::bench {

// Forwards every message to the watchers, then answers its sender with it.
class RawRouter {
 public:
  RawRouter();
  const std::string& address() const { return address_; }

 private:
  explicit RawRouter(std::string address);
  Child process_;
  std::string address_;
};

class RawDealer {
 public:
  explicit RawDealer(const std::string& address);
  void send(std::string_view payload) { socket_.send(zmq::buffer(payload)); }
  std::string_view receive();
  // Becomes one that everything is forwarded to.
  void watch();

 private:
  zmq::context_t context_{1};
  zmq::socket_t socket_;
  zmq::message_t message_;
};

}  // namespace pizarra::bench
