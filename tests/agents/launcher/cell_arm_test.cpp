// The words of a cell file about an arm's controller reach the driver.

#include "agents/launcher/cell_arm.hpp"

#include <gtest/gtest.h>

#include "blackboard/time/real_executor.hpp"
#include "drivers/arm/arm_file.hpp"
#include "drivers/line/tcp_port.hpp"
#include "tests/drivers/arm/plain/plain_motoros.hpp"
#include "tests/drivers/arm/plain/plain_simple.hpp"
#include "tests/run_task.hpp"

namespace pizarra::launcher {
namespace {

TEST(CellArm, SpeaksSimpleMessageInTheByteOrderThatTheCellNames) {
  for (const line::ByteOrder order : {line::ByteOrder::little, line::ByteOrder::big}) {
    RealExecutor executor;
    const arm::ArmModel model = arm::shipped_arm("scara").value();
    arm::PlainSimple controller(model, order);
    const auto motion = std::move(line::TcpPort::listen(executor, "127.0.0.1", 0).value());
    const auto state = std::move(line::TcpPort::listen(executor, "127.0.0.1", 0).value());
    const Job moving = executor.spawn(arm::serve_motion(executor, controller, *motion));
    const Job telling = executor.spawn(arm::serve_state(executor, controller, *state));
    simulation::NoLink none;
    for (const std::string protocol :
         {"simple-message", "simple-message-big-endian", "simple-message-track", "simple-message-track-big-endian"}) {
      forms::ArmLine line;
      line.protocol = protocol;
      line.places = {"127.0.0.1"};
      line.ports = {motion->port(), state->port()};
      Parts parts;
      arm::ArmDriver& arm = add_cell_arm(parts, executor, line, model, none);
      const bool same = protocol.ends_with("big-endian") == (order == line::ByteOrder::big);
      const Result<std::string> type = run(executor, arm.identify());
      EXPECT_EQ(type.has_value(), same) << protocol;
    }
  }
}

TEST(CellArm, SpeaksMotorosInTheByteOrderThatTheCellNames) {
  for (const line::ByteOrder order : {line::ByteOrder::little, line::ByteOrder::big}) {
    RealExecutor executor;
    const arm::ArmModel model = arm::shipped_arm("motoman-up6").value();
    arm::PlainMotoros controller(model, order);
    const auto motion = std::move(line::TcpPort::listen(executor, "127.0.0.1", 0).value());
    const auto state = std::move(line::TcpPort::listen(executor, "127.0.0.1", 0).value());
    const Job moving = executor.spawn(arm::serve_motion(executor, controller, *motion));
    const Job telling = executor.spawn(arm::serve_state(executor, controller, *state));
    simulation::NoLink none;
    for (const std::string protocol : {"motoros", "motoros-big-endian"}) {
      forms::ArmLine line;
      line.protocol = protocol;
      line.places = {"127.0.0.1"};
      line.ports = {motion->port(), state->port()};
      Parts parts;
      arm::ArmDriver& arm = add_cell_arm(parts, executor, line, model, none);
      const bool same = (protocol == "motoros-big-endian") == (order == line::ByteOrder::big);
      const Result<std::string> type = run(executor, arm.identify());
      EXPECT_EQ(type.has_value(), same) << protocol;
    }
  }
}

}  // namespace
}  // namespace pizarra::launcher
