#include "blackboard/wire/socket_events.hpp"

#include <cstring>

namespace pizarra::wire {

namespace {

constexpr const char* events_at = "inproc://events";

}  // namespace

SocketEvents::SocketEvents(Executor& executor, zmq::context_t& context, zmq::socket_t& socket, int which,
                           Listener listener)
    : executor_(executor), watched_(socket), listener_(std::move(listener)), events_(context, zmq::socket_type::pair) {
  events_.set(zmq::sockopt::linger, 0);
  zmq_socket_monitor(watched_.handle(), events_at, which);
  events_.connect(events_at);
  file_ = events_.get(zmq::sockopt::fd);
  executor_.watch_readable(file_, [this] { pump(); });
  // ZeroMQ tells the file of what comes after something was looked for in vain.
  pump();
}

SocketEvents::~SocketEvents() {
  executor_.unwatch_readable(file_);
  zmq_socket_monitor(watched_.handle(), nullptr, 0);
}

void SocketEvents::pump() {
  try {
    zmq::message_t event;
    while (events_.recv(event, zmq::recv_flags::dontwait)) {
      std::uint16_t kind = 0;
      std::uint32_t value = 0;
      const bool formed = event.size() == sizeof kind + sizeof value;
      if (formed) std::memcpy(&kind, event.data(), sizeof kind);
      if (formed) std::memcpy(&value, static_cast<const char*>(event.data()) + sizeof kind, sizeof value);
      while (event.more() && events_.recv(event)) {
      }
      listener_(kind, value);
    }
  } catch (const zmq::error_t&) {
    // Interrupted by a signal: the next event brings this one along.
  }
}

}  // namespace pizarra::wire
