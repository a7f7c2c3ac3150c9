// A peer may break a socket's connections, but not the socket.

#include "blackboard/wire/wire_socket.hpp"

#include <gtest/gtest.h>
#include <thread>

#include "blackboard/time/real_executor.hpp"
#include "tests/scratch.hpp"

namespace pizarra {
namespace {

constexpr std::size_t frame_bytes = 8 << 10;

class Peer {
 public:
  explicit Peer(const std::string& address) : socket_(context_, zmq::socket_type::dealer) {
    // Long enough for what the other end has room for.
    socket_.set(zmq::sockopt::linger, 500);
    socket_.set(zmq::sockopt::sndhwm, 0);
    socket_.connect(address);
  }
  void send(const std::string& frame) { socket_.send(zmq::buffer(frame)); }

 private:
  zmq::context_t context_{1};
  zmq::socket_t socket_;
};

TEST(WireSocket, APeerThatGoesWhileItsFramesAreHeldBackEndsItsOwnConnectionAlone) {
  RealExecutor executor;
  int held_back = 0;
  bool other_heard = false;
  wire::WireSocket router(executor, wire::WireSocket::Kind::router,
                          [&](const std::string&, std::optional<std::string_view> frame) {
                            if (frame->size() == frame_bytes) ++held_back;
                            if (*frame == "other") other_heard = true;
                          });
  const std::string address = router.bind("ipc://" + scratch_folder() + "half_open").value();
  {
    Peer gone(address);
    for (int i = 0; i < 4 * wire::WireSocket::high_water; ++i) gone.send(std::string(frame_bytes, 'x'));
  }
  // ZeroMQ's own threads go on meanwhile: a beat of theirs every two seconds would fall into it.
  std::this_thread::sleep_for(3s);
  Peer other(address);
  other.send("other");
  const Time deadline = executor.now() + 10s;
  const auto tick = executor.call_at(deadline, [] {});
  executor.run_until([&] { return other_heard || executor.now() >= deadline; });
  executor.cancel(tick);
  EXPECT_TRUE(other_heard);
  EXPECT_GT(held_back, 0);
}

TEST(WireSocket, HasHeardUntilLaterTimesHoweverMuchComes) {
  RealExecutor executor;
  int heard = 0;
  wire::WireSocket router(executor, wire::WireSocket::Kind::router,
                          [&](const std::string&, std::optional<std::string_view>) {
                            // More has come when this is done.
                            std::this_thread::sleep_for(100us);
                            ++heard;
                          });
  Peer flooder(router.bind("ipc://" + scratch_folder() + "flooded").value());
  constexpr int flood = 4000;
  for (int i = 0; i < flood; ++i) flooder.send("x");
  executor.run_until([&] { return heard > 0; });
  const Time begun = executor.now();
  executor.run_until([&] { return router.heard_until() > begun || heard == flood; });
  EXPECT_GT(router.heard_until(), begun);
  EXPECT_LT(heard, flood);
}

}  // namespace
}  // namespace pizarra
