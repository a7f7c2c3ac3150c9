#pragma once

// Tells a client when its connection is let in, and why it is not: ZeroMQ itself says nothing and gives up.
//
//   HandshakeWatch watch(executor, context, socket, with_key,
//                        {.let_in = [&] { ... }, .refused = [&](const Failure& failure) { ... }});
//
// Failures: not-permitted (the board refuses this key, wants a key, or wants none). unreachable (the handshake broke
// off again and again, as it does when the client knows another key of the board).

#include "blackboard/wire/frame_socket.hpp"
#include "blackboard/wire/socket_events.hpp"

namespace pizarra::wire {

class HandshakeWatch {
 public:
  using Listener = FrameSocket::Listener;

  // Before the socket connects; the socket outlives it.
  HandshakeWatch(Executor& executor, zmq::context_t& context, zmq::socket_t& socket, bool with_key, Listener listener);
  HandshakeWatch(const HandshakeWatch&) = delete;
  HandshakeWatch& operator=(const HandshakeWatch&) = delete;

 private:
  void note(std::uint16_t event, std::uint32_t value);
  Failure failure_of(std::uint16_t event, std::uint32_t value) const;

  const bool with_key_;
  const Listener listener_;
  int broken_off_ = 0;  // so many times one after another
  SocketEvents events_;
};

}  // namespace pizarra::wire
