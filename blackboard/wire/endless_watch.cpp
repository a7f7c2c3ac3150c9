#include "blackboard/wire/endless_watch.hpp"

#include <linux/tcp.h>
#include <netinet/in.h>
#include <sys/socket.h>

namespace pizarra::wire {

namespace {

// Nothing where ZeroMQ has closed the file, or it is none of tcp.
std::optional<std::uint64_t> bytes_received(int file) {
  tcp_info info{};
  socklen_t size = sizeof info;
  if (getsockopt(file, IPPROTO_TCP, TCP_INFO, &info, &size) != 0) return std::nullopt;
  return info.tcpi_bytes_received;
}

// ZeroMQ then closes the file, and the other end hears of it at once, though not all was read that it has sent.
void end(int file) {
  const linger at_once{.l_onoff = 1, .l_linger = 0};
  setsockopt(file, SOL_SOCKET, SO_LINGER, &at_once, sizeof at_once);
  shutdown(file, SHUT_RDWR);
}

}  // namespace

EndlessWatch::EndlessWatch(Executor& executor, zmq::context_t& context, zmq::socket_t& socket,
                           std::uint64_t longest_message, Listener listener)
    : executor_(executor),
      longest_message_(longest_message),
      listener_(std::move(listener)),
      events_(executor, context, socket, ZMQ_EVENT_ACCEPTED | ZMQ_EVENT_CLOSED | ZMQ_EVENT_DISCONNECTED,
              [this](std::uint16_t event, std::uint32_t value) { note(event, value); }) {
  timer_ = executor_.call_at(executor_.now() + period, [this] { look(); });
}

void EndlessWatch::note(std::uint16_t event, std::uint32_t value) {
  const int file = static_cast<int>(value);
  if (const auto known = connections_.find(file); known != connections_.end()) {
    clear(known->second);
    connections_.erase(known);
  }
  if (event == ZMQ_EVENT_ACCEPTED) connections_[file] = {};
}

void EndlessWatch::heard(zmq::message_t& message) {
  const auto known = connections_.find(zmq_msg_get(message.handle(), ZMQ_SRCFD));
  if (known == connections_.end() || !known->second.is_suspect) return;
  clear(known->second);
  known->second.received = bytes_received(known->first).value_or(0);
}

void EndlessWatch::look() {
  for (auto& [file, connection] : connections_) look_at(file, connection);
  timer_ = executor_.call_at(executor_.now() + period, [this] { look(); });
}

void EndlessWatch::look_at(int file, Connection& connection) {
  const std::optional<std::uint64_t> received = bytes_received(file);
  if (!received) return;
  // The file may be that of another connection by now.
  if (*received < connection.received) connection.received = *received;
  if (*received - connection.received <= longest_message_) return;
  if (!connection.is_suspect) {
    connection.is_suspect = true;
    connection.received = *received;
    ++suspects_;
  } else if (!connection.over) {
    connection.over = executor_.now();
  } else if (*connection.over < listener_.heard_until()) {
    end(file);
    clear(connection);
    connection.received = *received;
    listener_.ended();
  }
}

void EndlessWatch::clear(Connection& connection) {
  if (connection.is_suspect) --suspects_;
  connection.is_suspect = false;
  connection.over.reset();
}

}  // namespace pizarra::wire
