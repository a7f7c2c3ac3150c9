// The client interfaces of the emulated Universal Robots controller, as the maker's tables lay them out and its C++
// client library uses them; and programs that the dashboard loads.

#include <algorithm>
#include <gtest/gtest.h>
#include <numbers>

#include "blackboard/time/virtual_executor.hpp"
#include "drivers/arm/arm_file.hpp"
#include "drivers/simulation/controllers/arms/moving_arm.hpp"
#include "drivers/simulation/controllers/arms/ur_emulator.hpp"
#include "lisp/numbers.hpp"
#include "tests/drivers/line/wire_pair.hpp"
#include "tests/run_task.hpp"

namespace pizarra::arm {
namespace {

using simulation::UrInterface;

class UrInterfaces : public testing::Test {
 protected:
  static std::optional<std::string> stored(std::string_view name) {
    if (name == "wait.urp") return "sleep(2)\ntextmsg(\"waited\")\n";
    if (name == "go.urp") return "movej(" + joints(0.5) + ", t=2)\nmovej(" + joints(1) + ", t=2)\n";
    return std::nullopt;
  }
  static const ArmModel& model() {
    static const ArmModel ur5e = shipped_arm("ur5e").value();
    return ur5e;
  }
  // The ready position, the first axis by so much further, as URScript has joints.
  static std::string joints(double more_rad) {
    std::string text = "[" + std::to_string(radians(model().ready[0]) + more_rad);
    for (std::size_t axis = 1; axis < 4; ++axis) text += ", " + std::to_string(radians(model().ready[axis]));
    return text + ", -1.5707963, " + std::to_string(radians(model().ready[4])) + "]";
  }
  void SetUp() override {
    for (line::WirePair* line : {&primary_line, &real_time_line, &dashboard_line}) {
      ASSERT_TRUE(run(executor, line->near.open(executor.now() + 1s)));
    }
    executor.run_for(5ms);
    heard(primary_line);
    heard(dashboard_line);
  }
  std::string heard(line::WirePair& line) {
    const Result<std::string> octets = run(executor, line.near.read(executor.now()));
    return octets.value_or("");
  }
  // Packages at the primary interface within `time`: each its type and what it says.
  std::vector<std::string> packages(Duration time) {
    executor.run_for(time);
    std::vector<std::string> all;
    const std::string octets = heard(primary_line);
    std::string_view left = octets;
    while (left.size() >= 5) {
      const std::size_t size = line::OctetReader(left, line::ByteOrder::big).u32();
      EXPECT_LE(size, left.size());
      all.emplace_back(left.substr(4, size - 4));
      left.remove_prefix(std::min(size, left.size()));
    }
    return all;
  }
  // What is said of programs: kind and text, from behind type, time, source.
  std::vector<std::string> messages(Duration time) {
    std::vector<std::string> all;
    for (const std::string& package : packages(time)) {
      if (package[0] == 20) all.push_back(package.substr(10));
    }
    return all;
  }
  bool is_said(const std::vector<std::string>& said, char kind, std::string_view text) {
    return std::ranges::any_of(
        said, [&](const std::string& message) { return message[0] == kind && message.find(text) != message.npos; });
  }
  std::string newest_state() {
    std::string state;
    for (const std::string& package : packages(200ms)) {
      if (package[0] == 16) state = package.substr(1);
    }
    return state;
  }
  int robot_mode() { return newest_state().at(5 + 8 + 7); }
  void switch_on() {
    say("set robotmode run");
    executor.run_for(1s);
  }
  void say(const std::string& words) { ASSERT_TRUE(primary_line.near.write(words + "\n")); }
  std::string dashboard(const std::string& line) {
    EXPECT_TRUE(dashboard_line.near.write(line + "\n"));
    executor.run_for(20ms);
    return heard(dashboard_line);
  }
  double joint_deg(std::size_t axis) { return run(executor, cabinet.read()).joints[axis]; }

  VirtualExecutor executor;
  simulation::MovingArm body{executor, model()};
  simulation::ArmCabinet cabinet{executor, body, model()};
  simulation::UrEmulator emulator{cabinet, stored};
  line::WirePair primary_line{executor}, real_time_line{executor}, dashboard_line{executor};
  Job primary{executor.spawn(simulation::serve_interface(executor, emulator, UrInterface::primary, primary_line.far))};
  Job real_time{
      executor.spawn(simulation::serve_interface(executor, emulator, UrInterface::real_time, real_time_line.far))};
  Job answering{executor.spawn(simulation::serve_dashboard(executor, emulator, dashboard_line.far))};
};

TEST_F(UrInterfaces, ANewClientHearsTheVersionFirst) {
  ASSERT_TRUE(run(executor, primary_line.near.open(executor.now() + 1s)));
  const std::vector<std::string> said = packages(5ms);
  ASSERT_FALSE(said.empty());
  EXPECT_EQ(said[0].substr(0, 1) + said[0].substr(10, 11), std::string("\x14\x03\x09URControl", 12));
  EXPECT_EQ(said[0].substr(21, 6), std::string("\5\x0b\0\0\0\0", 6));
}

TEST_F(UrInterfaces, ThePrimaryTellsTenStatesASecondOfPackagesAsLongAsTheTablesSay) {
  std::size_t states = 0;
  for (const std::string& package : packages(1s)) states += package[0] == 16 ? 1 : 0;
  EXPECT_NEAR(static_cast<double>(states), 10, 1);
  std::string state = newest_state();
  std::vector<std::pair<int, std::size_t>> sizes;
  while (state.size() >= 5) {
    const std::size_t size = line::OctetReader(state, line::ByteOrder::big).u32();
    sizes.emplace_back(state[4], size);
    ASSERT_LE(size, state.size());
    state.erase(0, size);
  }
  const std::vector<std::pair<int, std::size_t>> tables{{0, 47},  {1, 251}, {2, 37}, {3, 75},  {4, 101}, {5, 225},
                                                        {6, 445}, {7, 61},  {8, 9},  {11, 26}, {12, 8}};
  EXPECT_EQ(sizes, tables);
}

TEST_F(UrInterfaces, TheRealTimePacketHasItsFieldsWhereTheTablesHaveThem) {
  switch_on();
  heard(real_time_line);
  executor.run_for(1s);
  const std::string packets = heard(real_time_line);
  EXPECT_NEAR(static_cast<double>(packets.size()) / 1220, 500, 2);
  const auto at = [&](std::size_t octet) {
    return line::OctetReader(std::string_view(packets).substr(octet), line::ByteOrder::big).f64();
  };
  EXPECT_EQ(line::OctetReader(packets, line::ByteOrder::big).u32(), 1220u);
  for (const std::size_t joints_at : {12, 252}) {
    for (std::size_t axis = 0; axis < 4; ++axis) {
      EXPECT_NEAR(at(joints_at + 8 * axis), radians(model().ready[axis]), 1e-9) << joints_at << " " << axis;
    }
  }
  EXPECT_EQ(at(756), 7) << "robot mode";
  EXPECT_EQ(at(764), 253) << "joint mode";
  EXPECT_EQ(at(812), 1) << "safety mode";
  EXPECT_EQ(at(940), 1) << "speed scaling";
  EXPECT_EQ(at(1052), 1) << "program state";
  EXPECT_EQ(at(1108), 1) << "safety status";
}

TEST_F(UrInterfaces, WordsSwitchTheArmOnAndOff) {
  EXPECT_EQ(robot_mode(), 3);
  say("power on");
  EXPECT_EQ(robot_mode(), 5);
  say("set robotmode run");
  executor.run_for(1s);
  EXPECT_EQ(robot_mode(), 7);
  EXPECT_EQ(dashboard("robotmode"), "Robotmode: RUNNING\n");
  say("power off");
  EXPECT_EQ(robot_mode(), 3);
}

TEST_F(UrInterfaces, AProgramIsSaidToBeginAndToEndWithItsName) {
  switch_on();
  messages(0ms);
  say("def there():\n  movej(" + joints(0.3) + ", t=0.5)\n  textmsg(\"hello\")\nend");
  const std::vector<std::string> begun = messages(100ms);
  EXPECT_TRUE(is_said(begun, 7, "PROGRAM_XXX_STARTEDthere"));
  EXPECT_FALSE(is_said(begun, 7, "PROGRAM_XXX_STOPPEDthere"));
  const std::vector<std::string> ended = messages(2s);
  EXPECT_TRUE(is_said(ended, 0, "hello"));
  EXPECT_TRUE(is_said(ended, 7, "PROGRAM_XXX_STOPPEDthere"));
  EXPECT_NEAR(joint_deg(0), model().ready[0] + degrees(0.3), 0.01);
  say("def long():\n  sleep(9)\nend");
  messages(100ms);
  say("stop program");
  EXPECT_TRUE(is_said(messages(100ms), 7, "PROGRAM_XXX_STOPPEDlong"));
}

TEST_F(UrInterfaces, WhyAProgramIsNotTakenIsSaid) {
  switch_on();
  messages(0ms);
  say("def bad():\n  sleep(0.1)\n  movel(somewhere)\nend");
  const std::vector<std::string> said = messages(300ms);
  EXPECT_TRUE(is_said(said, 10, std::string("\0\0\0\3", 4))) << "its line";
  EXPECT_FALSE(is_said(said, 7, "PROGRAM_XXX_STARTED"));
  ASSERT_TRUE(cabinet.obey("pendant on"));
  say("def never():\n  sleep(0.1)\nend");
  EXPECT_TRUE(is_said(messages(300ms), 6, std::string("\0\0\0\xd2", 4))) << "code 210";
}

TEST_F(UrInterfaces, TheDashboardLoadsPlaysPausesAndStopsAStoredProgram) {
  EXPECT_EQ(dashboard("load nothing.urp"), "File not found: nothing.urp\n");
  EXPECT_EQ(dashboard("play"), "Failed to execute: play\n");
  EXPECT_EQ(dashboard("load wait.urp"), "Loading program: wait.urp\n");
  EXPECT_EQ(dashboard("programState"), "STOPPED wait.urp\n");
  EXPECT_EQ(dashboard("get loaded program"), "Loaded program: wait.urp\n");
  EXPECT_EQ(dashboard("play"), "Failed to execute: play\n") << "the arm is off";
  switch_on();
  EXPECT_EQ(dashboard("play"), "Starting program\n");
  EXPECT_EQ(dashboard("programState"), "PLAYING wait.urp\n");
  executor.run_for(500ms);
  EXPECT_EQ(dashboard("pause"), "Pausing program\n");
  EXPECT_EQ(dashboard("programState"), "PAUSED wait.urp\n");
  EXPECT_FALSE(is_said(messages(5s), 0, "waited")) << "time does not pass in it";
  EXPECT_EQ(dashboard("play"), "Starting program\n");
  EXPECT_TRUE(is_said(messages(2s), 0, "waited"));
  EXPECT_EQ(dashboard("programState"), "STOPPED wait.urp\n");
  EXPECT_EQ(dashboard("play"), "Starting program\n");
  EXPECT_EQ(dashboard("stop"), "Stopped\n");
  EXPECT_EQ(dashboard("running"), "Program running: false\n");
}

TEST_F(UrInterfaces, AMoveThatWasPausedGoesOnWhereItStands) {
  switch_on();
  dashboard("load go.urp");
  dashboard("play");
  executor.run_for(3s);
  dashboard("pause");
  executor.run_for(1s);
  const double stands = joint_deg(0);
  EXPECT_GT(stands, model().ready[0] + degrees(0.55)) << "beyond the first of its two ends";
  executor.run_for(1s);
  EXPECT_EQ(joint_deg(0), stands);
  dashboard("play");
  for (int look = 0; look < 100; ++look) {
    executor.run_for(50ms);
    EXPECT_GE(joint_deg(0), stands - 1e-6) << "it does not go back";
  }
  EXPECT_NEAR(joint_deg(0), model().ready[0] + degrees(1), 0.01);
}

}  // namespace
}  // namespace pizarra::arm
