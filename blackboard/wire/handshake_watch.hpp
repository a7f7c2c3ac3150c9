#pragma once

// Tells a client why its connection is not let in: ZeroMQ itself says nothing and gives up.
//
//   HandshakeWatch watch(executor, context, socket, [&](const Failure& failure) { ... });
//
// Failures: not-permitted (the board refuses this key, wants a key, or wants none), unreachable (the handshake broke
// off again and again, as it does when the board's key is not the one that the client knows).

#include <functional>
#include <zmq.hpp>

#include "blackboard/time/executor.hpp"
#include "lisp/result.hpp"

namespace pizarra {

class HandshakeWatch {
 public:
  using Refused = std::function<void(const Failure&)>;

  // Before the socket connects; the socket outlives it.
  HandshakeWatch(Executor& executor, zmq::context_t& context, zmq::socket_t& socket, bool with_key, Refused refused);
  HandshakeWatch(const HandshakeWatch&) = delete;
  HandshakeWatch& operator=(const HandshakeWatch&) = delete;
  ~HandshakeWatch();

 private:
  void pump();
  void note(std::uint16_t event, std::uint32_t value);
  Failure failure_of(std::uint16_t event, std::uint32_t value) const;

  Executor& executor_;
  zmq::socket_t& watched_;
  const bool with_key_;
  Refused refused_;
  zmq::socket_t events_;
  int file_;
  int broken_off_ = 0;  // so many times one after another
};

}  // namespace pizarra
