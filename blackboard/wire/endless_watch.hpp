#pragma once

// Ends the connections on which a message comes that does not end: one of part after part, each within ZeroMQ's bound,
// which keeps them all until the last has come and tells nobody.
//
//   EndlessWatch watch(executor, context, router, {.heard_until = [&] { ... }, .ended = [&] { ... }});
//   if (watch.suspects_any()) watch.heard(message);        // every message that is received
//
// Twenty times a second it asks the network what has come on each connection. Where more came than a whole message
// takes, it listens for messages from there; where as much comes again and none is received, the connection is ended,
// once all has been received that had come by then. Of tcp alone: over ipc the network does not count, and the file's
// permissions say who comes.

#include <functional>
#include <map>
#include <optional>

#include "blackboard/wire/socket_events.hpp"

namespace pizarra::wire {

class EndlessWatch {
 public:
  static constexpr Duration period = 50ms;

  struct Listener {
    std::function<Time()> heard_until;  // as of WireSocket
    std::function<void()> ended;
  };

  // Before the socket is bound; it outlives this.
  EndlessWatch(Executor& executor, zmq::context_t& context, zmq::socket_t& socket, std::uint64_t longest_message,
               Listener listener);
  EndlessWatch(const EndlessWatch&) = delete;
  EndlessWatch& operator=(const EndlessWatch&) = delete;
  ~EndlessWatch() { executor_.cancel(timer_); }

  bool suspects_any() const { return suspects_ > 0; }
  void heard(zmq::message_t& message);

 private:
  struct Connection {
    std::uint64_t received = 0;  // bytes, up to which whole messages may have come
    bool is_suspect = false;     // none has, beyond these
    std::optional<Time> over;    // since when more than one takes came beyond these
  };
  void note(std::uint16_t event, std::uint32_t value);
  void look();
  void look_at(int file, Connection& connection);
  void clear(Connection& connection);

  Executor& executor_;
  const std::uint64_t longest_message_;
  const Listener listener_;
  std::map<int, Connection> connections_;  // by their files
  std::size_t suspects_ = 0;
  Executor::TimerId timer_ = 0;
  SocketEvents events_;
};

}  // namespace pizarra::wire
