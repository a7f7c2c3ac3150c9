#include "drivers/line/serial_wire.hpp"

#include <gtest/gtest.h>

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

TEST(SerialWire, WhatIsNoLineIsRefused) {
  RealExecutor executor;
  SerialWire wire(executor, "/dev/null", 9600, Parity::even);
  EXPECT_EQ(run(executor, wire.open(executor.now() + 1s)).error().symbol, "disconnected");
}

}  // namespace
}  // namespace pizarra::line
