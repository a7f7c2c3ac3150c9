#include <gtest/gtest.h>

#include "blackboard/time/real_executor.hpp"
#include "blackboard/time/virtual_executor.hpp"
#include "drivers/line/exchanges.hpp"
#include "drivers/line/octets.hpp"
#include "drivers/line/udp_wire.hpp"
#include "tests/drivers/line/lossy_line.hpp"
#include "tests/run_task.hpp"

namespace pizarra::line {
namespace {

// A device that repeats what it hears; the first octet is the id.
std::optional<std::uint32_t> first_octet(std::string_view datagram) {
  if (datagram.empty()) return std::nullopt;
  return static_cast<unsigned char>(datagram.front());
}

TEST(Octets, NumbersComeBackInEitherOrderAndStandAsTheWireHasThem) {
  for (const ByteOrder order : {ByteOrder::little, ByteOrder::big}) {
    OctetWriter writer(order);
    writer.u8(7).u16(0x1234).u32(0xdeadbeef).i32(-2).f32(1.5f).f64(-0.1).text("end").zeros(2);
    OctetReader read(writer.octets(), order);
    EXPECT_EQ(read.u8(), 7);
    EXPECT_EQ(read.u16(), 0x1234);
    EXPECT_EQ(read.u32(), 0xdeadbeef);
    EXPECT_EQ(read.i32(), -2);
    EXPECT_EQ(read.f32(), 1.5f);
    EXPECT_EQ(read.f64(), -0.1);
    EXPECT_EQ(read.text(3), "end");
    EXPECT_FALSE(read.whole());
    EXPECT_EQ(read.u16(), 0);
    EXPECT_TRUE(read.whole());
    EXPECT_EQ(read.u16(), 0);
    EXPECT_FALSE(read.sound());
  }
  EXPECT_EQ(OctetWriter(ByteOrder::little).u16(0x20).octets(), std::string("\x20\0", 2));
  EXPECT_EQ(OctetWriter(ByteOrder::big).u16(0x20).octets(), std::string("\0\x20", 2));
}

TEST(Exchanges, ARequestIsSentAgainUntilItsOwnReplyComes) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    VirtualExecutor executor;
    LossyLine line(executor, Random(seed), [](std::string said) -> Task<std::string> { co_return said; });
    line.loss = 0.3;
    line.duplication = 0.3;
    line.longest_delay = 60ms;
    Exchanges exchanges(executor, line, first_octet);
    ASSERT_TRUE(run(executor, exchanges.open(executor.now() + 1s)));
    for (int i = 0; i < 200; ++i) {
      const auto id = static_cast<std::uint8_t>(i);
      const std::string request = OctetWriter(ByteOrder::little).u8(id).u32(static_cast<std::uint32_t>(i)).octets();
      const Result<std::string> reply = run(executor, exchanges.ask(id, request));
      ASSERT_TRUE(reply) << "seed " << seed << ", request " << i;
      EXPECT_EQ(*reply, request) << "seed " << seed;
    }
  }
}

TEST(Exchanges, WhereNobodyAnswersItFailsInTime) {
  VirtualExecutor executor;
  LossyLine line(executor, Random(1), [](std::string) -> Task<std::string> { co_return std::string(); });
  Exchanges exchanges(executor, line, first_octet);
  ASSERT_TRUE(run(executor, exchanges.open(executor.now() + 1s)));
  const Time before = executor.now();
  const Result<std::string> reply = run(executor, exchanges.ask(1, "\1", {.tries = 5, .pause = 40ms}));
  ASSERT_FALSE(reply);
  EXPECT_EQ(reply.error().symbol, "no-answer");
  EXPECT_EQ(executor.now() - before, 200ms);
  EXPECT_EQ(line.sent, 5u);
}

TEST(Udp, ADeviceAnswersWhoeverAskedIt) {
  RealExecutor executor;
  const auto port = UdpPort::listen(executor, "127.0.0.1", 0);
  ASSERT_TRUE(port) << describe(port.error());
  const Job echoing = executor.spawn([](Executor& clock, UdpPort& device) -> Task<void> {
    while (true) {
      const Result<std::string> said = co_await device.receive(clock.now() + 10s);
      if (said) static_cast<void>(device.send(*said));
    }
  }(executor, **port));
  for (int client = 0; client < 3; ++client) {
    UdpWire wire(executor, "localhost", (*port)->port());
    ASSERT_TRUE(run(executor, wire.open(executor.now() + 1s)));
    ASSERT_TRUE(wire.send("hello"));
    const Result<std::string> heard = run(executor, wire.receive(executor.now() + 2s));
    ASSERT_TRUE(heard) << describe(heard.error());
    EXPECT_EQ(*heard, "hello");
  }
}

TEST(Udp, WhatIsNotThereIsSaidInASentence) {
  RealExecutor executor;
  UdpWire nowhere(executor, "no-such-host.invalid", 10040);
  const Result<void> open = run(executor, nowhere.open(executor.now() + 1s));
  ASSERT_FALSE(open);
  EXPECT_EQ(open.error().symbol, "disconnected");
  EXPECT_EQ(UdpPort::listen(executor, "192.0.2.1", 0).error().symbol, "bad-address");
}

}  // namespace
}  // namespace pizarra::line
