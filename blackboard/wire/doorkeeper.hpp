#pragma once

// Answers ZeroMQ's question whether a client with this CURVE key may connect (ZAP, RFC 27). Without an answerer
// ZeroMQ lets every client in.
//
//   Doorkeeper doorkeeper(executor, context, [&](const std::string& key) { return keys.find(key) != nullptr; });
//
// One for a ZeroMQ context, made before what it guards is bound. Messages of those let in carry their public key, in
// Z85, as "User-Id".

#include <zmq.hpp>

#include "blackboard/wire/frame_socket.hpp"

namespace pizarra::wire {

class Doorkeeper {
 public:
  using Admit = FrameSocket::Admit;

  Doorkeeper(Executor& executor, zmq::context_t& context, Admit admit);
  Doorkeeper(const Doorkeeper&) = delete;
  Doorkeeper& operator=(const Doorkeeper&) = delete;
  ~Doorkeeper();

 private:
  void pump();
  bool answer_one();
  void schedule_pump();

  Executor& executor_;
  Admit admit_;
  zmq::socket_t socket_;
  int file_;
  Executor::TimerId pump_timer_ = 0;
};

}  // namespace pizarra::wire
