#include "tests/drivers/gripper/plain_gripper.hpp"

#include <cmath>
#include <gtest/gtest.h>

#include "blackboard/time/real_executor.hpp"
#include "drivers/gripper/modbus_gripper.hpp"
#include "drivers/line/tcp_port.hpp"
#include "tests/run_task.hpp"

namespace pizarra::gripper {
namespace {

// In real time, as libmodbus has a socket.
class OnAPlainGripper : public testing::Test {
 protected:
  GripperReading wait() {
    Result<GripperReading> reading = run(executor, driver.read());
    const Time deadline = executor.now() + 10s;
    while (reading && reading->moving && executor.now() < deadline) {
      run(executor, nap());
      reading = run(executor, driver.read());
    }
    EXPECT_TRUE(reading) << describe(reading.error());
    return reading.value_or(GripperReading{});
  }
  Task<bool> nap() {
    co_await sleep(executor, 20ms);
    co_return true;
  }

  RealExecutor executor;
  forms::GripperSetup setup;
  PlainGripper gripper;
  std::unique_ptr<line::TcpPort> port = std::move(line::TcpPort::listen(executor, "127.0.0.1", 0).value());
  Job serving{executor.spawn(serve_gripper(executor, gripper, *port))};
  ModbusClient client{executor, "127.0.0.1", port->port(), setup.unit};
  ModbusGripper driver{executor, client, setup};
};

TEST_F(OnAPlainGripper, IsActivatedOpensAndClosesAsTheManualHasIt) {
  EXPECT_FALSE(run(executor, driver.read())) << "it is not activated";
  const Result<void> ready = run(executor, driver.connect());
  ASSERT_TRUE(ready) << describe(ready.error());
  const double middle_mm = (setup.open_mm + setup.closed_mm) / 2;
  ASSERT_TRUE(run(executor, driver.start(middle_mm)));
  const GripperReading there = wait();
  EXPECT_NEAR(there.opening_mm, middle_mm, (setup.open_mm - setup.closed_mm) / 255);
  EXPECT_FALSE(there.gripped);
  const int writes = gripper.writes;
  ASSERT_TRUE(run(executor, driver.connect()));
  EXPECT_EQ(gripper.writes, writes) << "one that is ready is left as it is";
}

TEST_F(OnAPlainGripper, SaysThatItHoldsSomething) {
  gripper.stops_at = 150;
  ASSERT_TRUE(run(executor, driver.connect()));
  ASSERT_TRUE(run(executor, driver.start(setup.closed_mm)));
  const GripperReading there = wait();
  EXPECT_TRUE(there.gripped);
  EXPECT_NEAR(there.opening_mm, std::lerp(setup.open_mm, setup.closed_mm, 150.0 / 255), 1);
}

}  // namespace
}  // namespace pizarra::gripper
