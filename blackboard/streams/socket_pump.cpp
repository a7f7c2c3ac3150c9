#include "blackboard/streams/socket_pump.hpp"

namespace pizarra::streams {

SocketPump::SocketPump(Executor& executor, zmq::socket_t& socket, Receiver receiver)
    : executor_(executor), socket_(socket), receiver_(std::move(receiver)), file_(socket.get(zmq::sockopt::fd)) {
  executor_.watch_readable(file_, [this] { pump(); });
  schedule();
}

SocketPump::~SocketPump() {
  executor_.unwatch_readable(file_);
  if (timer_ != 0) executor_.cancel(timer_);
}

void SocketPump::schedule() {
  if (timer_ != 0) return;
  timer_ = executor_.call_at(executor_.now(), [this] {
    timer_ = 0;
    pump();
  });
}

// One at a time, because the receiver may destroy this.
void SocketPump::pump() {
  zmq::message_t part;
  try {
    if (!socket_.recv(part, zmq::recv_flags::dontwait)) return;
  } catch (const zmq::error_t&) {
    // Interrupted by a signal.
    return schedule();
  }
  schedule();
  receiver_(part);
}

}  // namespace pizarra::streams
