// The messages that Universal Robots' own Python client for the data exchange sends to the emulated controller, and
// people at its script and dashboard ports, with the answers that they must get.

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "drivers/line/octets.hpp"
#include "lisp/numbers.hpp"
#include "tests/drivers/arm/driven_cells.hpp"

namespace pizarra::arm {
namespace {

class UrClients : public testing::Test, protected DrivenUniversal {
 protected:
  // Messages of the data exchange that came within `time`, each its type and what it says.
  std::vector<std::string> hear(Duration time) {
    executor.run_for(time);
    const Time now = executor.now();
    std::vector<std::string> messages;
    const Result<std::string> octets = ask(rtde_line.near.read(now));
    std::string_view left = octets ? std::string_view(*octets) : std::string_view();
    while (left.size() >= 3) {
      const std::size_t size = line::OctetReader(left, line::ByteOrder::big).u16();
      messages.emplace_back(left.substr(2, size - 2));
      left.remove_prefix(size);
    }
    return messages;
  }
  std::string say(char type, const std::string& payload) {
    EXPECT_TRUE(rtde_line.near.write(rtde::write(type, payload)));
    for (const std::string& message : hear(20ms)) {
      if (message.front() == type) return message.substr(1);
    }
    return "nothing";
  }
  void connect_exchange() {
    ASSERT_TRUE(ask(rtde_line.near.open(executor.now() + 1s)));
    EXPECT_EQ(say('V', std::string("\0\2", 2)), std::string(1, '\1'));
  }
  static std::string at(double per_s, std::string_view names) {
    return line::OctetWriter(line::ByteOrder::big).f64(per_s).text(names).octets();
  }
  std::size_t told_in_a_second() {
    std::size_t told = 0;
    for (const std::string& message : hear(1s)) told += message.front() == 'U' ? 1 : 0;
    return told;
  }
  void script(std::string_view text) {
    ASSERT_TRUE(ask(script_line.near.open(executor.now() + 1s)));
    ASSERT_TRUE(cabinet.servo(true) == simulation::Refusal::none);
    executor.run_for(1s);
    ASSERT_TRUE(script_line.near.write(text));
  }
  std::string dashboard(const std::string& line) {
    EXPECT_TRUE(dashboard_line.near.write(line + "\n"));
    executor.run_for(20ms);
    const Result<std::string> said = ask(dashboard_line.near.read(executor.now() + 1s));
    return said.value_or(said ? "" : said.error().symbol);
  }
  double joint(std::size_t axis) { return ask(cabinet.read()).joints[axis]; }
  // How long until the arm stands, once it has begun.
  double seconds_moving() {
    executor.run_for(50ms);
    EXPECT_TRUE(ask(cabinet.read()).moving);
    const Time begun = executor.now();
    while (ask(cabinet.read()).moving) executor.run_for(5ms);
    return std::chrono::duration<double>(executor.now() - begun).count() + 0.05;
  }
  // The ready position, the first axis by so much further, as URScript has joints.
  std::string joints(double more_rad) {
    std::string text = "[" + std::to_string(radians(model().ready[0]) + more_rad);
    for (std::size_t axis = 1; axis < 4; ++axis) text += ", " + std::to_string(radians(model().ready[axis]));
    return text + ", -1.5707963, " + std::to_string(radians(model().ready[4])) + "]";
  }
};

TEST_F(UrClients, TheMakersClientAgreesOnRecipesStartsAndPauses) {
  connect_exchange();
  EXPECT_EQ(say('v', ""), line::OctetWriter(line::ByteOrder::big).u32(5).u32(11).u32(0).u32(108249).octets());
  EXPECT_EQ(say('S', ""), std::string(1, '\0')) << "nothing is agreed on yet";
  EXPECT_EQ(say('O', at(125, "target_q,target_qd,output_int_register_0")), "\1VECTOR6D,VECTOR6D,INT32");
  EXPECT_EQ(say('I', "input_double_register_0,input_double_register_1"), "\1DOUBLE,DOUBLE");
  EXPECT_EQ(say('I', "input_int_register_0"), "\2INT32");
  EXPECT_EQ(say('S', ""), std::string(1, '\1'));
  EXPECT_NEAR(static_cast<double>(told_in_a_second()), 125, 2);
  EXPECT_EQ(say('P', ""), std::string(1, '\1'));
  EXPECT_EQ(told_in_a_second(), 0u);
  EXPECT_EQ(say('S', ""), std::string(1, '\1'));
  EXPECT_NEAR(static_cast<double>(told_in_a_second()), 125, 2);
}

TEST_F(UrClients, NamesThatThereAreNotAreNamedAndTheRecipeIsNone) {
  connect_exchange();
  EXPECT_EQ(say('O', at(125, "actual_q,colour")), std::string(1, '\0') + "VECTOR6D,NOT_FOUND");
  EXPECT_EQ(say('I', "input_int_register_48")[0], '\0');
  EXPECT_EQ(say('O', at(501, "actual_q"))[0], '\0');
  EXPECT_EQ(say('S', ""), std::string(1, '\0'));
}

TEST_F(UrClients, EachClientIsToldAtItsOwnRate) {
  connect_exchange();
  say('O', at(125, "timestamp"));
  say('S', "");
  EXPECT_NEAR(static_cast<double>(told_in_a_second()), 125, 2);
  connect_exchange();
  say('O', at(500, "timestamp"));
  say('S', "");
  EXPECT_NEAR(static_cast<double>(told_in_a_second()), 500, 5);
}

TEST_F(UrClients, WhatIsToldStandsInTheRecipesOrderAndTypes) {
  connect_exchange();
  say('O', at(10, "actual_digital_output_bits,robot_mode,input_int_register_7,actual_q,safety_status,joint_mode"));
  say('I', "input_int_register_7");
  script("sec io():\n  set_digital_out(3, True)\nend\n");
  say('S', "");
  ASSERT_TRUE(rtde_line.near.write(rtde::write('U', std::string("\1\0\0\1\2", 5))));
  executor.run_for(1s);
  const std::vector<std::string> heard = hear(200ms);
  ASSERT_FALSE(heard.empty());
  line::OctetReader read(std::string_view(heard.back()).substr(1), line::ByteOrder::big);
  EXPECT_EQ(read.u8(), 1);
  EXPECT_EQ(read.u32(), 0u);
  EXPECT_EQ(read.u32(), 8u);
  EXPECT_EQ(read.i32(), 7);
  EXPECT_EQ(read.i32(), 258);
  for (std::size_t axis = 0; axis < 4; ++axis) EXPECT_NEAR(read.f64(), radians(model().ready[axis]), 1e-9);
  EXPECT_NEAR(read.f64(), -std::numbers::pi / 2, 1e-9);
  EXPECT_NEAR(read.f64(), radians(model().ready[4]), 1e-9);
  EXPECT_EQ(read.i32(), 1);
  for (int axis = 0; axis < 6; ++axis) EXPECT_EQ(read.i32(), 253);
  EXPECT_TRUE(read.whole());
}

TEST_F(UrClients, OneLineAloneIsAProgram) {
  script("movej(" + joints(0.5) + ")\n");
  executor.run_for(5s);
  EXPECT_NEAR(joint(0), model().ready[0] + degrees(0.5), 1e-3);
}

TEST_F(UrClients, ArgumentsCountByTheirPlacesAsByTheirNames) {
  script("movej(" + joints(0.5) + ", 1.4, 0.1)\n");
  EXPECT_NEAR(seconds_moving(), 5, 0.5);
  script("movej(" + joints(0) + ", v=0.1, a=1.4)\n");
  EXPECT_NEAR(seconds_moving(), 5, 0.5);
}

TEST_F(UrClients, ATimeOutweighsTheSpeed) {
  script("movej(" + joints(0.5) + ", a=1.4, v=1.05, t=4)\n");
  EXPECT_NEAR(seconds_moving(), 4, 0.5);
  script("movej(" + joints(0) + ", 1.4, 1.05, 4, 0)\n");
  EXPECT_NEAR(seconds_moving(), 4, 0.5);
}

TEST_F(UrClients, APoseIsGoneToWithTheFlange) {
  const ToolPose begin = forward(model(), ask(cabinet.read()).joints);
  const Eigen::Vector3d flange = (begin.translation() - model().tool_mm * begin.linear().col(2)) / 1000;
  const Eigen::AngleAxisd turn(Eigen::Matrix3d(begin.linear()));
  const Eigen::Vector3d vector = turn.angle() * turn.axis();
  std::string pose = "p[" + std::to_string(flange.x()) + "," + std::to_string(flange.y()) + ",";
  pose += std::to_string(flange.z() + 0.05);
  for (const double part : {vector.x(), vector.y(), vector.z()}) pose += "," + std::to_string(part);
  script("movel(" + pose + "], a=1.2, v=0.1)\n");
  executor.run_for(5s);
  const ToolPose end = forward(model(), ask(cabinet.read()).joints);
  EXPECT_NEAR(end.translation().z() - begin.translation().z(), 50, 0.1);
  EXPECT_NEAR(end.translation().x(), begin.translation().x(), 0.1);
}

TEST_F(UrClients, MessagesAndOutputsDoNotDropAProgram) {
  script("def p():\n  textmsg(\"going (now), \", 1)\n  set_digital_out(0, True)\n  movej(" + joints(0.2) + ")\nend\n");
  executor.run_for(5s);
  EXPECT_NEAR(joint(0), model().ready[0] + degrees(0.2), 1e-3);
}

TEST_F(UrClients, AProgramBesideAnotherLeavesItRunning) {
  script("def p():\n  movej(" + joints(1) + ", v=0.2)\nend\n");
  executor.run_for(1s);
  ASSERT_TRUE(script_line.near.write("sec s():\n  set_tool_digital_out(0, True)\nend\n"));
  executor.run_for(8s);
  EXPECT_NEAR(joint(0), model().ready[0] + degrees(1), 1e-3);
}

TEST_F(UrClients, TheDashboardAnswersWhatItsManualLists) {
  ASSERT_TRUE(ask(dashboard_line.near.open(executor.now() + 1s)));
  executor.run_for(20ms);
  EXPECT_EQ(dashboard("safetystatus"), "Connected: Universal Robots Dashboard Server\nSafetystatus: NORMAL\n");
  EXPECT_EQ(dashboard("programState"), "STOPPED <unnamed>\n");
  EXPECT_EQ(dashboard("load a.urp"), "File not found: a.urp\n");
  EXPECT_EQ(dashboard("play"), "Failed to execute: play\n");
  EXPECT_EQ(dashboard("pause"), "Failed to execute: pause\n");
  EXPECT_EQ(dashboard("get loaded program"), "No program loaded\n");
  EXPECT_EQ(dashboard("popup hello"), "showing popup\n");
  ASSERT_TRUE(cabinet.obey("estop on"));
  EXPECT_EQ(dashboard("safetymode"), "Safetymode: ROBOT_EMERGENCY_STOP\n");
  EXPECT_EQ(dashboard("quit"), "Disconnected\n");
  EXPECT_FALSE(dashboard_line.near.write("robotmode\n")) << "it has hung up";
}

// The example recipes of the maker's C++ client library.
TEST_F(UrClients, TheSpeedSliderIsWhatAnInputSays) {
  connect_exchange();
  EXPECT_EQ(say('O', at(50, "target_speed_fraction,standard_analog_input0,tcp_offset,tool_mode")),
            "\1DOUBLE,DOUBLE,VECTOR6D,UINT32");
  EXPECT_EQ(say('I', "speed_slider_mask,speed_slider_fraction"), "\1UINT32,DOUBLE");
  EXPECT_EQ(say('I', "external_force_torque"), "\2VECTOR6D");
  const auto slide = [&](std::uint32_t mask, double fraction) {
    const std::string input = line::OctetWriter(line::ByteOrder::big).u8(1).u32(mask).f64(fraction).octets();
    EXPECT_TRUE(rtde_line.near.write(rtde::write('U', input)));
    executor.run_for(20ms);
    return cabinet.speed_override();
  };
  EXPECT_EQ(slide(1, 0.4), 0.4);
  EXPECT_EQ(slide(0, 0.9), 0.4) << "it is not meant";
  EXPECT_EQ(slide(1, 0), 0.01) << "the slowest";
  EXPECT_EQ(slide(1, 7), 1);
}

TEST_F(UrClients, DigitalOutputsAreWhatTheMaskOfAnInputMeans) {
  connect_exchange();
  EXPECT_EQ(say('O', at(100, "actual_digital_output_bits")), "\1UINT64");
  EXPECT_EQ(say('I', "standard_digital_output,standard_digital_output_mask"), "\1UINT8,UINT8");
  EXPECT_EQ(say('I', "tool_digital_output_mask,tool_digital_output"), "\2UINT8,UINT8");
  EXPECT_EQ(say('S', ""), "\1");
  const auto outputs_after = [&](std::string input) {
    EXPECT_TRUE(rtde_line.near.write(rtde::write('U', std::move(input))));
    const std::vector<std::string> told = hear(100ms);
    return told.empty() ? '\0' : told.back().back() + 256 * told.back()[told.back().size() - 3];
  };
  EXPECT_EQ(outputs_after("\1\7\3"), 3);
  EXPECT_EQ(outputs_after(std::string("\1\0\1", 3)), 2);
  EXPECT_EQ(outputs_after("\2\1\3"), 2 + 256);
}

}  // namespace
}  // namespace pizarra::arm
