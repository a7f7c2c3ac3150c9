#pragma once

// Lets go of a TCP connection whose other end went without a word, so that ZeroMQ connects again and its queue is
// freed.
//
//   let_go_when_half_open(socket);   // before it is bound or connected; ipc has no such ends
//
// TCP itself looks after what is idle (SO_KEEPALIVE) and what is not taken (TCP_USER_TIMEOUT). ZeroMQ's own heartbeats
// must stay off: where a peer goes while messages from it are held back at the high water mark, libzmq 4.3.4 ends the
// whole program at the next beat ("Assertion failed: !_io_error").

#include <zmq.hpp>

namespace pizarra::wire {

inline void let_go_when_half_open(zmq::socket_t& socket) {
  constexpr int idle_s = 2;
  constexpr int between_s = 2;
  constexpr int silent_ms = 6000;
  socket.set(zmq::sockopt::tcp_keepalive, 1);
  socket.set(zmq::sockopt::tcp_keepalive_idle, idle_s);
  socket.set(zmq::sockopt::tcp_keepalive_intvl, between_s);
  socket.set(zmq::sockopt::tcp_keepalive_cnt, silent_ms / 1000 / between_s);
  socket.set(zmq::sockopt::tcp_maxrt, silent_ms);
}

}  // namespace pizarra::wire
