#pragma once

// The events of a ZeroMQ socket's connections, as its monitor tells them.
//
//   SocketEvents events(executor, context, socket, ZMQ_EVENT_ACCEPTED,
//                       [&](std::uint16_t event, std::uint32_t value) { ... });
//
// Made before the socket binds or connects. The socket outlives it, and has no other.

#include <cstdint>
#include <functional>
#include <zmq.hpp>

#include "blackboard/time/executor.hpp"

namespace pizarra::wire {

class SocketEvents {
 public:
  // zmq_socket_monitor(3) says what the value of each event is.
  using Listener = std::function<void(std::uint16_t event, std::uint32_t value)>;

  SocketEvents(Executor& executor, zmq::context_t& context, zmq::socket_t& socket, int which, Listener listener);
  SocketEvents(const SocketEvents&) = delete;
  SocketEvents& operator=(const SocketEvents&) = delete;
  ~SocketEvents();

 private:
  void pump();

  Executor& executor_;
  zmq::socket_t& watched_;
  const Listener listener_;
  zmq::socket_t events_;
  int file_;
};

}  // namespace pizarra::wire
