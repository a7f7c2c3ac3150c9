// The driver and the emulator over lines of this machine, in real time.

#include <gtest/gtest.h>

#include "blackboard/time/real_executor.hpp"
#include "drivers/line/pty_wire.hpp"
#include "drivers/line/serial_wire.hpp"
#include "drivers/line/tcp_port.hpp"
#include "drivers/line/tcp_wire.hpp"
#include "drivers/ptu/ptu_driver.hpp"
#include "drivers/simulation/controllers/serve.hpp"
#include "tests/drivers/ptu/wire_to_unit.hpp"

namespace pizarra::ptu {
namespace {

class Lines : public testing::Test {
 protected:
  // Connects, moves a little, and reads that it is there.
  void drive(PtuDriver& driver) {
    const Result<PanTiltRange> range = run(executor, driver.connect());
    ASSERT_TRUE(range) << describe(range.error());
    const Result<void> moved = run(executor, driver.move_to(PanTiltAxis::pan, 2));
    ASSERT_TRUE(moved) << describe(moved.error());
    Result<PanTiltReading> reading = run(executor, driver.read());
    while (reading && reading->moving) reading = run(executor, driver.read());
    ASSERT_TRUE(reading) << describe(reading.error());
    EXPECT_NEAR(reading->pan_deg, 2, 0.03);
  }

  RealExecutor executor;
  simulation::PtuEmulator unit{executor, *simulation::find_ptu_model("ptu46-17.5")};
};

TEST_F(Lines, APseudoTerminalIsASerialLine) {
  const auto line = line::PtyWire::make(executor);
  ASSERT_TRUE(line);
  const Job serving = executor.spawn(simulation::serve(executor, unit, **line));
  line::SerialWire wire(executor, (*line)->path(), 9600);
  PtuDriver driver(executor, wire);
  drive(driver);
  // One that comes after it finds the line in order.
  driver.close();
  PtuDriver next(executor, wire);
  drive(next);
}

TEST_F(Lines, OverTcpOneClientFollowsAnother) {
  const auto port = line::TcpPort::listen(executor, "127.0.0.1", 0);
  ASSERT_TRUE(port) << describe(port.error());
  const Job serving = executor.spawn(simulation::serve(executor, unit, **port));
  line::TcpWire wire(executor, "localhost", (*port)->port());
  PtuDriver driver(executor, wire);
  drive(driver);
  driver.close();
  drive(driver);
}

TEST_F(Lines, WhereNobodyListensOpeningFailsInASentence) {
  std::uint16_t free_port = 0;
  {
    const auto port = line::TcpPort::listen(executor, "127.0.0.1", 0);
    ASSERT_TRUE(port);
    free_port = (*port)->port();
  }
  line::TcpWire tcp(executor, "127.0.0.1", free_port);
  const Result<void> refused = run(executor, tcp.open(executor.now() + 2s));
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().symbol, "disconnected");
  line::SerialWire serial(executor, "/dev/no-such-line", 9600);
  EXPECT_EQ(run(executor, serial.open(executor.now() + 2s)).error().symbol, "disconnected");
  line::SerialWire odd(executor, "/dev/null", 1234);
  EXPECT_EQ(run(executor, odd.open(executor.now() + 2s)).error().symbol, "bad-baud");
}

TEST_F(Lines, AnEndThatGoesAwayIsNoticedByTheOther) {
  auto port = line::TcpPort::listen(executor, "127.0.0.1", 0);
  ASSERT_TRUE(port);
  Job serving = executor.spawn(simulation::serve(executor, unit, **port));
  line::TcpWire wire(executor, "127.0.0.1", (*port)->port());
  PtuDriver driver(executor, wire);
  ASSERT_TRUE(run(executor, driver.connect()));
  serving = Job();
  port->reset();
  const Result<PanTiltReading> reading = run(executor, driver.read());
  ASSERT_FALSE(reading);
  EXPECT_EQ(reading.error().symbol, "disconnected");
}

}  // namespace
}  // namespace pizarra::ptu
