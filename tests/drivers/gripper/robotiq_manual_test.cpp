// The examples of Robotiq's manuals and what ROS-Industrial's driver says, octet by octet, to the emulated gripper.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "blackboard/time/real_executor.hpp"
#include "drivers/arm/arm_file.hpp"
#include "drivers/line/tcp_wire.hpp"
#include "drivers/simulation/controllers/arms/moving_arm.hpp"
#include "drivers/simulation/controllers/gripper/modbus_server.hpp"
#include "tests/run_task.hpp"

namespace pizarra::gripper {
namespace {

std::string in_hex(std::string_view octets) {
  std::string out;
  for (const char octet : octets) out += fmt::format("{:02X} ", static_cast<unsigned char>(octet));
  if (!out.empty()) out.pop_back();
  return out;
}

std::string from_hex(std::string_view text) {
  std::string out;
  for (std::size_t at = 0; at < text.size(); at += 3) {
    out += static_cast<char>(std::stoi(std::string(text.substr(at, 2)), nullptr, 16));
  }
  return out;
}

class RobotiqManual : public testing::Test {
 protected:
  void SetUp() override {
    server = std::move(simulation::ModbusServer::listen(executor, gripper, "127.0.0.1", 0).value());
    wire.emplace(executor, "127.0.0.1", server->port());
    ASSERT_TRUE(run(executor, wire->open(executor.now() + 1s)));
  }
  // The answer to the unit's number and the octets after it; without the header, whose numbers must be the request's.
  std::string say(const std::string& hex) {
    const std::string request = from_hex(hex);
    const std::string header = from_hex("77 6B 00 00 00 ") + static_cast<char>(request.size());
    EXPECT_TRUE(wire->write(header + request));
    const Result<std::string> reply = run(executor, wire->read(executor.now() + 2s));
    if (!reply || reply->size() < 7) return "";
    EXPECT_EQ(in_hex(reply->substr(0, 4)), "77 6B 00 00");
    EXPECT_EQ(static_cast<std::size_t>((*reply)[5]), reply->size() - 6);
    return in_hex(std::string_view(*reply).substr(6));
  }
  // Asks until the answer is another one.
  std::string after(const std::string& question, const std::string& first) {
    std::string answer = say(question);
    for (int i = 0; i < 500 && answer.starts_with(first); ++i) {
      run(executor, nap());
      answer = say(question);
    }
    return answer;
  }
  Task<bool> nap() {
    co_await sleep(executor, 10ms);
    co_return true;
  }
  void activate() {
    say("09 10 03 E8 00 03 06 01 00 00 00 00 00");
    after("09 04 07 D0 00 01", "09 04 02 11");
  }

  RealExecutor executor;
  simulation::MovingArm body{executor, arm::crs_f3()};
  simulation::GripperEmulator gripper{executor, body, forms::GripperSetup()};
  std::unique_ptr<simulation::ModbusServer> server;
  std::optional<line::TcpWire> wire;
};

TEST_F(RobotiqManual, ActivationIsToldUnderWayAndDone) {
  EXPECT_EQ(say("09 04 07 D0 00 01"), "09 04 02 00 00");
  EXPECT_EQ(say("09 10 03 E8 00 03 06 01 00 00 00 00 00"), "09 10 03 E8 00 03");
  EXPECT_EQ(say("09 04 07 D0 00 01"), "09 04 02 11 00");
  EXPECT_EQ(after("09 04 07 D0 00 01", "09 04 02 11"), "09 04 02 31 00");
}

TEST_F(RobotiqManual, ClosingAndOpeningAreToldWithWhatWasAskedFor) {
  activate();
  EXPECT_EQ(say("09 10 03 E8 00 03 06 09 00 00 FF FF FF"), "09 10 03 E8 00 03");
  EXPECT_EQ(say("09 04 07 D0 00 03").substr(0, 20), "09 04 06 39 00 00 FF");
  EXPECT_EQ(after("09 04 07 D0 00 03", "09 04 06 39"), "09 04 06 F9 00 00 FF FF 00");
  EXPECT_EQ(say("09 10 03 E8 00 03 06 09 00 00 00 FF FF"), "09 10 03 E8 00 03");
  EXPECT_EQ(after("09 04 07 D0 00 03", "09 04 06 39"), "09 04 06 F9 00 00 00 00 00");
}

TEST_F(RobotiqManual, TheSameIsAnsweredToFunctionThree) {
  activate();
  EXPECT_EQ(say("09 03 07 D0 00 01"), "09 03 02 31 00");
  EXPECT_EQ(say("09 03 03 E8 00 01"), "09 03 02 01 00");
}

TEST_F(RobotiqManual, WhatIsWrittenAndReadAtOnceIsReadAfterwards) {
  activate();
  EXPECT_EQ(say("09 17 07 D0 00 02 03 E8 00 03 06 09 00 00 E6 FF FF"), "09 17 04 39 00 00 E6");
}

// ROS-Industrial's driver over Modbus TCP has both from register 0 on, and calls the gripper ready by gSTA and gACT.
TEST_F(RobotiqManual, RosDriverFindsItReadyAtRegisterZero) {
  EXPECT_EQ(say("00 10 00 00 00 03 06 01 00 00 00 FF 96"), "00 10 00 00 00 03");
  EXPECT_EQ(after("00 04 00 00 00 03", "00 04 06 11").substr(0, 14), "00 04 06 31 00");
  EXPECT_EQ(say("00 10 00 00 00 03 06 09 00 00 80 FF 96"), "00 10 00 00 00 03");
  EXPECT_EQ(after("00 04 00 00 00 03", "00 04 06 39"), "00 04 06 F9 00 00 80 80 00");
}

// That driver's simple controller activates the gripper and has it go in one message: it goes once it is active.
TEST_F(RobotiqManual, WhatItIsToldWhileItIsActivatedIsDoneAfterwards) {
  EXPECT_EQ(say("00 10 00 00 00 03 06 09 00 00 FF FF 96"), "00 10 00 00 00 03");
  EXPECT_EQ(after("00 04 00 00 00 03", "00 04 06 19").substr(0, 17), "00 04 06 39 00 00");
  EXPECT_EQ(after("00 04 00 00 00 03", "00 04 06 39"), "00 04 06 F9 00 00 FF FF 00");
}

TEST_F(RobotiqManual, ItStopsWhereItIsWhenItIsToldToGoNoFurther) {
  activate();
  say("09 10 03 E8 00 03 06 09 00 00 FF FF FF");
  run(executor, nap());
  say("09 10 03 E8 00 01 02 01 00");
  for (int i = 0; i < 20; ++i) run(executor, nap());
  const std::string stands = say("09 04 07 D2 00 01");
  EXPECT_TRUE(stands.starts_with("09 04 02")) << stands;
  EXPECT_NE(stands, "09 04 02 FF 00");
  for (int i = 0; i < 20; ++i) run(executor, nap());
  EXPECT_EQ(say("09 04 07 D2 00 01"), stands);
}

TEST_F(RobotiqManual, RegistersThatItDoesNotHaveAndCountsThatDoNotFitAreExceptions) {
  EXPECT_EQ(say("09 04 01 00 00 01"), "09 84 02");
  EXPECT_EQ(say("09 04 03 E8 00 01"), "09 84 02") << "orders are no inputs";
  EXPECT_EQ(say("09 04 07 D2 00 02"), "09 84 02");
  EXPECT_EQ(say("09 06 07 D0 01 00"), "09 86 02") << "its state is not written";
  EXPECT_EQ(say("09 10 03 E8 00 03 04 01 00 00 00"), "09 90 03");
  EXPECT_EQ(say("09 01 00 00 00 01"), "09 81 02") << "it has no coils";
}

}  // namespace
}  // namespace pizarra::gripper
