#pragma once

// Reads a ZeroMQ socket on the executor. Its file says that something changed, once, and sending may consume that sign:
// who has sent schedules another look.
//
//   SocketPump pump(executor, socket, [&](const zmq::message_t& part) { ... });
//   socket.send(...);
//   pump.schedule();
//
// The socket outlives it.

#include <functional>
#include <zmq.hpp>

#include "blackboard/time/executor.hpp"

namespace pizarra::streams {

class SocketPump {
 public:
  using Receiver = std::function<void(const zmq::message_t& part)>;

  SocketPump(Executor& executor, zmq::socket_t& socket, Receiver receiver);
  SocketPump(const SocketPump&) = delete;
  SocketPump& operator=(const SocketPump&) = delete;
  ~SocketPump();

  void schedule();

 private:
  void pump();

  Executor& executor_;
  zmq::socket_t& socket_;
  Receiver receiver_;
  int file_;
  Executor::TimerId timer_ = 0;
};

}  // namespace pizarra::streams
