#include "drivers/line/serial_wire.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "blackboard/time/real_executor.hpp"
#include "drivers/line/pty_wire.hpp"
#include "tests/run_task.hpp"

namespace pizarra::line {
namespace {

// As an emulated controller of a line with parity is opened.
TEST(SerialWire, AParityThatAPseudoTerminalCannotHaveDoesNotKeepItClosed) {
  RealExecutor executor;
  const auto device = PtyWire::make(executor);
  ASSERT_TRUE(device);
  for (const Parity parity : {Parity::even, Parity::even, Parity::none}) {
    SerialWire wire(executor, (*device)->path(), 9600, parity);
    const Time soon = executor.now() + 1s;
    const Result<void> open = run(executor, wire.open(soon));
    ASSERT_TRUE(open) << describe(open.error());
    ASSERT_TRUE(run(executor, (*device)->open(soon)));
    ASSERT_TRUE(wire.write("\x05\xff\n"));
    EXPECT_EQ(run(executor, (*device)->read(soon)).value_or("nothing"), "\x05\xff\n");
  }
}

// A late reader finds whole messages, however many were lost.
TEST(SerialWire, OfAMessageThatIsCutTheRestGoesBeforeTheNext) {
  RealExecutor executor;
  const auto device = PtyWire::make(executor);
  ASSERT_TRUE(device);
  const Time soon = executor.now() + 1s;
  ASSERT_TRUE(run(executor, (*device)->open(soon)));
  const std::string message = std::string(999, 'x') + "\n";
  for (int i = 0; i < 100; ++i) static_cast<void>((*device)->write(message));
  const int file = ::open((*device)->path().c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK);
  ASSERT_GE(file, 0);
  std::string all;
  const auto take = [&] {
    char chunk[4096];
    for (ssize_t count = ::read(file, chunk, sizeof chunk); count > 0; count = ::read(file, chunk, sizeof chunk)) {
      all.append(chunk, static_cast<std::size_t>(count));
    }
  };
  take();
  ASSERT_FALSE(all.empty());
  ASSERT_NE(all.size() % message.size(), 0u) << "one was cut";
  for (int i = 0; i < 3; ++i) {
    EXPECT_TRUE((*device)->write(message));
    take();
  }
  ::close(file);
  EXPECT_EQ(all.size() % message.size(), 0u);
  for (std::size_t at = 0; at + message.size() <= all.size(); at += message.size()) {
    EXPECT_EQ(all.substr(at, message.size()), message);
  }
}

TEST(SerialWire, WhatIsNoLineIsRefused) {
  RealExecutor executor;
  SerialWire wire(executor, "/dev/null", 9600, Parity::even);
  EXPECT_EQ(run(executor, wire.open(executor.now() + 1s)).error().symbol, "disconnected");
}

}  // namespace
}  // namespace pizarra::line
