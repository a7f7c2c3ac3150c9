// A peer may break a socket's connections, but not the socket.

#include "blackboard/wire/wire_socket.hpp"

#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <thread>
#include <unistd.h>

#include "blackboard/time/real_executor.hpp"
#include "blackboard/wire/wire_address.hpp"
#include "tests/has_ipv6.hpp"
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

TEST(WireSocket, ListensAndConnectsAtAddressesOfIpv6) {
  if (!has_ipv6()) GTEST_SKIP() << "this machine has no IPv6";
  RealExecutor executor;
  std::vector<std::string> heard;
  const auto hear = [&](const std::string&, std::optional<std::string_view> frame) { heard.emplace_back(*frame); };
  wire::WireSocket router(executor, wire::WireSocket::Kind::router, hear);
  const Result<std::string> at = router.bind("tcp://[::1]:*");
  ASSERT_TRUE(at.has_value()) << describe(at.error());
  EXPECT_TRUE(at->starts_with("tcp://[::1]:")) << *at;
  const Result<std::string> beside = router.bind("tcp://127.0.0.1:*");
  ASSERT_TRUE(beside.has_value()) << describe(beside.error());
  EXPECT_TRUE(beside->starts_with("tcp://127.0.0.1:")) << *beside;
  wire::WireSocket dealer(executor, wire::WireSocket::Kind::dealer, hear);
  const auto say = [&](const std::string& what) {
    const Time deadline = executor.now() + 10s;
    const std::size_t before = heard.size();
    while (heard.size() == before && executor.now() < deadline) {
      const auto tick = executor.call_at(executor.now() + 20ms, [&] { (void)dealer.send("", what); });
      const Time looks_at = executor.now() + 100ms;
      const auto look = executor.call_at(looks_at, [] {});
      executor.run_until([&] { return heard.size() > before || executor.now() >= looks_at; });
      executor.cancel(tick);
      executor.cancel(look);
    }
  };
  ASSERT_TRUE(dealer.connect(*at).has_value());
  say("by IPv6");
  dealer.connect_to(*beside);
  say("by IPv4");
  ASSERT_GE(heard.size(), 2u);
  EXPECT_EQ(heard.front(), "by IPv6");
  EXPECT_EQ(heard.back(), "by IPv4");
}

TEST(WireAddress, OfIpv6IsInBracketsAndHasNothingElseThere) {
  EXPECT_TRUE(wire::check_address("tcp://[fd00::1]:7943").has_value());
  EXPECT_TRUE(wire::check_address("tcp://[::]:*").has_value());
  for (const char* wrong : {"tcp://fd00::1:7943", "tcp://[fd00::1:7943", "tcp://fd00::1]:7943", "tcp://[]:7943",
                            "tcp://[localhost]:7943", "tcp://[10.0.0.1]:7943", "tcp://[::1]", "tcp://:7943"}) {
    const Result<void> refused = wire::check_address(wrong);
    ASSERT_FALSE(refused.has_value()) << wrong;
    EXPECT_TRUE(refused.error().sentence.contains("an address of IPv6 is in brackets")) << refused.error().sentence;
  }
  EXPECT_TRUE(wire::check_listening_address("tcp://[::1]:7943", false).has_value());
  EXPECT_EQ(wire::check_listening_address("tcp://[fd00::1]:7943", false).error().symbol, "not-loopback");
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
