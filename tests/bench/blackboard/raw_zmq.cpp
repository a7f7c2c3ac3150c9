#include "tests/bench/blackboard/raw_zmq.hpp"

#include <unistd.h>
#include <vector>

namespace pizarra::bench {

namespace {

constexpr std::string_view watch_word = "watch";

void drop_nothing(zmq::socket_t& socket) {
  socket.set(zmq::sockopt::sndhwm, 0);
  socket.set(zmq::sockopt::rcvhwm, 0);
}

[[noreturn]] void route(const std::string& address) {
  zmq::context_t context{1};
  zmq::socket_t router(context, zmq::socket_type::router);
  drop_nothing(router);
  router.bind(address);
  std::vector<std::string> watchers;
  zmq::message_t peer;
  zmq::message_t payload;
  while (true) {
    (void)router.recv(peer);
    (void)router.recv(payload);
    if (payload.to_string_view() == watch_word) {
      watchers.push_back(peer.to_string());
    } else {
      for (const std::string& watcher : watchers) {
        router.send(zmq::buffer(watcher), zmq::send_flags::sndmore);
        router.send(zmq::buffer(payload.to_string_view()));
      }
    }
    router.send(peer, zmq::send_flags::sndmore);
    router.send(payload, zmq::send_flags::none);
  }
}

// A port that nobody listens at just now: bound by a socket that is closed again.
std::string free_address() {
  zmq::context_t context{1};
  zmq::socket_t socket(context, zmq::socket_type::router);
  socket.bind("tcp://127.0.0.1:*");
  return socket.get(zmq::sockopt::last_endpoint);
}

}  // namespace

RawRouter::RawRouter() : RawRouter(free_address()) {}
RawRouter::RawRouter(std::string address)
    : process_(Child::running([&](Pipe&) { route(address); })), address_(std::move(address)) {}

RawDealer::RawDealer(const std::string& address) : socket_(context_, zmq::socket_type::dealer) {
  socket_.set(zmq::sockopt::linger, 0);
  drop_nothing(socket_);
  socket_.connect(address);
}

std::string_view RawDealer::receive() {
  (void)socket_.recv(message_);
  return message_.to_string_view();
}

void RawDealer::watch() {
  send(watch_word);
  receive();
}

}  // namespace pizarra::bench
