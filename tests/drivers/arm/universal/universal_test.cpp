#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>

#include "blackboard/time/random.hpp"
#include "blackboard/time/real_executor.hpp"
#include "blackboard/time/virtual_executor.hpp"
#include "drivers/arm/arm_file.hpp"
#include "drivers/arm/kinematics.hpp"
#include "drivers/arm/route.hpp"
#include "drivers/arm/universal/universal_arm.hpp"
#include "drivers/line/tcp_port.hpp"
#include "drivers/line/tcp_wire.hpp"
#include "drivers/simulation/controllers/arms/moving_arm.hpp"
#include "drivers/simulation/controllers/arms/ur_emulator.hpp"
#include "tests/drivers/arm/driven_cells.hpp"
#include "tests/drivers/arm/plain/plain_universal.hpp"
#include "tests/drivers/line/wire_pair.hpp"

namespace pizarra::arm {
namespace {

const ArmModel& ur5e() {
  static const ArmModel model = shipped_arm("ur5e").value();
  return model;
}

class Universal : public testing::Test, protected DrivenUniversal {};

// The maker's Denavit-Hartenberg parameters, multiplied out.
Eigen::Isometry3d flange_by_maker(const Joints& joints) {
  constexpr double a[] = {0, -425, -392.2, 0, 0, 0};
  constexpr double d[] = {162.5, 0, 0, 133.3, 99.7, 99.6};
  constexpr double alpha[] = {std::numbers::pi / 2, 0, 0, std::numbers::pi / 2, -std::numbers::pi / 2, 0};
  const double q[] = {joints[0], joints[1], joints[2], joints[3], -90, joints[4]};
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  for (int i = 0; i < 6; ++i) {
    pose = pose * Eigen::AngleAxisd(q[i] * std::numbers::pi / 180, Eigen::Vector3d::UnitZ()) *
           Eigen::Translation3d(a[i], 0, d[i]) * Eigen::AngleAxisd(alpha[i], Eigen::Vector3d::UnitX());
  }
  return pose;
}

TEST(Ur5eModel, StandsWhereTheMakersParametersPutItAnywhere) {
  Random random(7);
  for (int i = 0; i < 2000; ++i) {
    Joints joints(5);
    for (std::size_t axis = 0; axis < 5; ++axis) {
      joints[axis] = random.uniform(ur5e().axes[axis].limits.low, ur5e().axes[axis].limits.high);
    }
    const ToolPose grip = forward(ur5e(), joints);
    const Eigen::Isometry3d flange = flange_by_maker(joints);
    const Eigen::Vector3d ours = grip.translation() - ur5e().tool_mm * grip.linear().col(2);
    ASSERT_LT((ours - flange.translation()).norm(), 1e-6) << "seed 7, case " << i;
    ASSERT_LT((grip.linear().col(2) - flange.linear().col(2)).norm(), 1e-9) << "seed 7, case " << i;
  }
}

TEST_F(Universal, SwitchesTheArmOnAndReadsWhereItIs) {
  EXPECT_EQ(ask(arm.identify()).value(), "ur5e");
  ASSERT_EQ(connect(), "");
  EXPECT_TRUE(cabinet.servo());
  const Result<ArmReading> reading = read();
  ASSERT_TRUE(reading);
  EXPECT_TRUE(are_same_place(reading->joints, ur5e().ready, 1e-6));
  EXPECT_FALSE(reading->moving);
}

// UR5 is what a CB3's UR5, whose links are others, and a UR5e both say.
TEST_F(Universal, AnArmOfAnotherModelOrSeriesOrOfNoneIsNotTakenForThisOne) {
  const auto says = [this](const std::string& model, const std::string& version) {
    dashboard_line.far.spoil = [=](const std::string& said) {
      if (said.starts_with("UR5")) return model + "\n";
      return said.starts_with("URSoftware") ? version + "\n" : said;
    };
    const Result<std::string> type = ask(arm.identify());
    return type ? *type : type.error().symbol;
  };
  EXPECT_EQ(says("UR5", "URSoftware 5.4.0"), "ur5e");
  EXPECT_EQ(says("UR5e", "URSoftware 5.4.0"), "ur5e");
  EXPECT_EQ(says("UR5", "URSoftware 3.15.0"), "ur5");
  EXPECT_EQ(says("UR10", "URSoftware 5.4.0"), "ur10e");
  EXPECT_EQ(says("UR20", "5.14.0"), "ur20");
  for (const char* none : {"u", "what?"}) EXPECT_EQ(says(none, "URSoftware 5.4.0"), "bad-reply") << none;
  EXPECT_EQ(says("", "URSoftware 5.4.0"), "disconnected") << "an empty line is no answer";
  EXPECT_EQ(says("UR5", "could not understand"), "bad-reply");
}

TEST_F(Universal, AStopGoesByTheDashboardWhereTheScriptsLineIsCut) {
  ASSERT_EQ(connect(), "");
  ASSERT_EQ(move({moved(0, 90)}, 0.3), "");
  executor.run_for(200ms);
  script_line.cut(true);
  EXPECT_EQ(outcome(arm.stop()), "");
  EXPECT_TRUE(wait()->stopped);
}

TEST_F(Universal, AStopFindsAScriptsLineThatWasLost) {
  ASSERT_EQ(connect(), "");
  ASSERT_EQ(move({moved(0, 90)}, 0.3), "");
  executor.run_for(200ms);
  script_line.far.close();
  dashboard_line.cut(true);
  EXPECT_EQ(outcome(arm.stop()), "");
  EXPECT_TRUE(wait()->stopped);
}

// In real time: what nobody reads fills a socket.
TEST(UniversalOverTcp, TheScriptsLineIsNotLostBecauseItsServerTalks) {
  RealExecutor executor;
  const auto port = [&] { return std::move(line::TcpPort::listen(executor, "127.0.0.1", 0).value()); };
  const auto rtde = port(), script = port(), dashboard = port();
  PlainUniversal controller(ur5e());
  controller.chatter.assign(40 << 10, 'x');
  const Job telling = executor.spawn(serve_rtde(executor, controller, *rtde));
  const Job running = executor.spawn(serve_script(executor, controller, *script));
  const Job answering = executor.spawn(serve_dashboard(executor, controller, *dashboard));
  line::TcpWire to_rtde(executor, "127.0.0.1", rtde->port());
  line::TcpWire to_script(executor, "127.0.0.1", script->port());
  line::TcpWire to_dashboard(executor, "127.0.0.1", dashboard->port());
  UniversalArm arm(executor, {to_rtde, to_script, to_dashboard}, ur5e());
  const Result<std::string> type = run(executor, arm.identify());
  ASSERT_TRUE(type) << describe(type.error());
  run(executor, [](Executor& clock) -> Task<bool> {
    co_await sleep(clock, 500ms);
    co_return true;
  }(executor));
  Joints there = ur5e().ready;
  there[0] += 10;
  const Result<void> begun = run(executor, arm.start_move({there}, 1));
  EXPECT_TRUE(begun) << describe(begun.error());
  EXPECT_TRUE(controller.arm.moving);
}

TEST_F(Universal, GoesThereAsOneProgramAndSaysWhenItStands) {
  ASSERT_EQ(connect(), "");
  const Joints there = moved(0, 40);
  Joints back = there;
  back[1] -= 20;
  EXPECT_EQ(outcome(arm.start_move({there, back}, 0.5)), "");
  EXPECT_TRUE(read()->moving);
  const Result<ArmReading> ended = wait();
  ASSERT_TRUE(ended);
  EXPECT_FALSE(ended->stopped);
  EXPECT_TRUE(are_same_place(ended->joints, back, 1e-3));
  EXPECT_EQ(cabinet.moves(), 1u);
}

TEST_F(Universal, ALineOfWaypointsIsOneLinearMoveAndStraight) {
  ASSERT_EQ(connect(), "");
  Joints at = read()->joints;
  const ToolPose begin = forward(ur5e(), at);
  std::vector<Joints> waypoints;
  for (int i = 1; i <= 40; ++i) {
    ToolPose pose = begin;
    pose.translation().z() -= 5 * i;
    at = inverse(ur5e(), pose, at).value();
    waypoints.push_back(at);
  }
  ASSERT_EQ(outcome(arm.start_move(waypoints, 1)), "");
  Result<ArmReading> reading = read();
  while (reading && reading->moving) {
    const Eigen::Vector3d here = forward(ur5e(), reading->joints).translation();
    EXPECT_LT((here - begin.translation()).head<2>().norm(), 0.1);
    executor.run_for(20ms);
    reading = read();
  }
  EXPECT_TRUE(are_same_place(reading->joints, at, 0.01));
  const std::string& program = script_line.near.written;
  EXPECT_NE(program.find("movel("), std::string::npos);
  EXPECT_EQ(program.find("movej("), std::string::npos) << program;
}

TEST_F(Universal, AStopBrakesAndTheNextMoveIsAskedAnew) {
  ASSERT_EQ(connect(), "");
  const Joints there = moved(0, 100);
  ASSERT_EQ(outcome(arm.start_move({there}, 1)), "");
  executor.run_for(300ms);
  EXPECT_EQ(outcome(arm.stop()), "");
  executor.run_for(20ms);
  const Result<ArmReading> ended = wait();
  ASSERT_TRUE(ended);
  EXPECT_TRUE(ended->stopped);
  EXPECT_FALSE(ended->why_stopped);
  EXPECT_FALSE(are_same_place(ended->joints, there, 1));
  EXPECT_EQ(outcome(arm.start_move({there}, 1)), "");
  EXPECT_TRUE(are_same_place(wait()->joints, there, 1e-3));
}

// A line that keeps what it is given for longer than a beginning is waited for.
TEST_F(Universal, AProgramThatComesTooLateIsNotGoneThrough) {
  ASSERT_EQ(connect(), "");
  const Joints there = moved(0, 100);
  std::string kept;
  script_line.near.spoil = [&kept](const std::string& program) {
    kept += program;
    return std::string();
  };
  ASSERT_EQ(outcome(arm.start_move({there}, 1)), "not-in-control");
  script_line.near.spoil = [&kept](const std::string& program) { return std::exchange(kept, {}) + program; };
  ASSERT_TRUE(script_line.near.write("\n"));
  executor.run_for(10s);
  EXPECT_FALSE(are_same_place(read()->joints, there, 20)) << "it went there after all";
}

TEST_F(Universal, WhatEndsAMoveIsNamedAndTheArmIsSwitchedOnOnlyWhenAsked) {
  ASSERT_EQ(connect(), "");
  const Joints there = moved(0, 100);
  ASSERT_EQ(outcome(arm.start_move({there}, 1)), "");
  executor.run_for(300ms);
  ASSERT_TRUE(cabinet.obey("alarm 5"));
  const Result<ArmReading> ended = wait();
  ASSERT_TRUE(ended);
  ASSERT_TRUE(ended->why_stopped);
  EXPECT_EQ(ended->why_stopped->symbol, "stopped");
  EXPECT_NE(ended->why_stopped->sentence.find("protective stop"), std::string::npos);
  EXPECT_EQ(outcome(arm.start_move({there}, 1)), "not-in-control");
  EXPECT_EQ(outcome(arm.take_control()), "");
  ASSERT_TRUE(cabinet.obey("estop on"));
  executor.run_for(50ms);
  EXPECT_EQ(outcome(arm.take_control()), "not-in-control");
  ASSERT_TRUE(cabinet.obey("estop off"));
  EXPECT_EQ(outcome(arm.take_control()), "");
  ASSERT_TRUE(cabinet.obey("pendant on"));
  EXPECT_EQ(outcome(arm.take_control()), "not-in-control");
  EXPECT_EQ(outcome(arm.start_move({there}, 1)), "not-in-control") << "in local control no program is taken";
}

TEST_F(Universal, IsSwitchedOffWhereControlIsReleased) {
  ASSERT_EQ(connect(), "");
  EXPECT_EQ(outcome(arm.release_control()), "");
  executor.run_for(1s);
  EXPECT_EQ(outcome(arm.start_move({moved(0, 100)}, 1)), "not-in-control");
  EXPECT_EQ(outcome(arm.take_control()), "");
  EXPECT_EQ(outcome(arm.start_move({moved(0, 100)}, 1)), "");
}

TEST_F(Universal, RefusesWhatItsAxesCannotAndWhatIsNoNumberAndSendsNothing) {
  ASSERT_EQ(connect(), "");
  const Result<void> beyond = ask(arm.start_move({moved(2, 500)}, 1));
  ASSERT_FALSE(beyond);
  EXPECT_EQ(beyond.error().symbol, "joint-limit");
  EXPECT_EQ(beyond.error().subject, to_datum(3));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(outcome(arm.start_move({moved(2, nan)}, 1)), "not-finite");
  EXPECT_EQ(outcome(arm.start_gripper(nan)), "not-finite");
  EXPECT_EQ(script_line.near.written, "");
}

TEST_F(Universal, PowerThatIsLostInMidMoveLeavesNothingKnown) {
  ASSERT_EQ(connect(), "");
  ASSERT_EQ(outcome(arm.start_move({moved(0, 100)}, 1)), "");
  executor.run_for(300ms);
  ASSERT_TRUE(cabinet.obey("power off"));
  executor.run_for(300ms);
  EXPECT_EQ(read().error().symbol, "disconnected");
  ASSERT_TRUE(cabinet.obey("power on"));
  EXPECT_EQ(connect(), "");
  EXPECT_FALSE(wait()->moving);
  EXPECT_EQ(outcome(arm.start_move({ur5e().ready}, 1)), "");
  EXPECT_TRUE(are_same_place(wait()->joints, ur5e().ready, 1e-3));
}

TEST_F(Universal, ACutLineIsOneClearFailureUntilItIsConnectedAnew) {
  ASSERT_EQ(connect(), "");
  rtde_line.cut(true);
  executor.run_for(10ms);
  EXPECT_EQ(read().error().symbol, "disconnected");
  EXPECT_EQ(outcome(arm.start_move({ur5e().home}, 1)), "disconnected");
  rtde_line.cut(false);
  EXPECT_EQ(connect(), "");
  EXPECT_TRUE(read());
}

TEST_F(Universal, AnAngleThatIsNoNumberIsNotTakenForOne) {
  ASSERT_EQ(connect(), "");
  rtde_line.far.spoil = [](std::string message) {
    if (message.size() < 60) return message;
    return message.substr(0, 12) + std::string(8, '\xff') + message.substr(20);
  };
  executor.run_for(50ms);
  EXPECT_TRUE(are_same_place(read()->joints, ur5e().ready, 1e-6)) << "the last that was sound";
  executor.run_for(200ms);
  const Result<ArmReading> reading = read();
  ASSERT_FALSE(reading);
  EXPECT_EQ(reading.error().symbol, "disconnected");
  EXPECT_NE(reading.error().sentence.find("axis 2"), std::string::npos) << reading.error().sentence;
}

TEST_F(Universal, TheGripperIsHeldToItsRegisters) {
  ASSERT_EQ(connect(), "");
  EXPECT_EQ(outcome(arm.start_gripper(40)), "");
  EXPECT_TRUE(read()->gripper_moving);
  EXPECT_NEAR(wait_for_gripper()->opening_mm, 40, 0.01);
}

TEST(Rtde, AMessageStandsAsTheGuideHasIt) {
  EXPECT_EQ(rtde::write('V', std::string("\0\2", 2)), std::string("\0\5V\0\2", 5));
}

TEST(Rtde, WhateverComesIsReadOrRefused) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    Random random(seed);
    const std::string sound = PlainUniversal(ur5e()).state();
    for (int i = 0; i < 20'000; ++i) {
      std::string damaged = sound;
      for (std::uint64_t edits = random.below(4); edits > 0; --edits) {
        damaged[random.below(damaged.size())] = static_cast<char>(random.below(256));
      }
      damaged.resize(random.below(damaged.size() + 1));
      const Result<std::optional<line::Frame>> frame = rtde::frame(damaged);
      if (!frame || !*frame) continue;
      ASSERT_LE((*frame)->octets, damaged.size()) << "seed " << seed;
      const Result<rtde::State> state = rtde::read_state((*frame)->message.substr(1));
      if (!state) continue;
      for (const double joint : state->joints_rad) ASSERT_TRUE(std::isfinite(joint)) << "seed " << seed;
    }
  }
}

TEST(UrScript, WhateverComesIsReadOrRefused) {
  const std::string sound =
      "def p():\n  movej([0, -1.57, 1.57, -1.57, -1.57, 0], a=1, v=0.5, r=0.001)\n"
      "  write_output_integer_register(24, 3)\n  stopj(8.0)\nend\n";
  ASSERT_EQ(simulation::read_urscript(sound)->size(), 3u);
  EXPECT_EQ(simulation::read_urscript("movej([0, 1, nan, 0, 0, 0])").error().symbol, "bad-script");
  EXPECT_EQ(simulation::read_urscript("set_digital_out(10, True)").error().symbol, "bad-script");
  EXPECT_EQ(simulation::read_urscript("while (True):").error().symbol, "bad-script");
  Random random(1);
  for (int i = 0; i < 20'000; ++i) {
    std::string damaged = sound;
    for (std::uint64_t edits = 1 + random.below(4); edits > 0; --edits) {
      damaged[random.below(damaged.size())] = static_cast<char>(random.below(128));
    }
    const Result<std::vector<simulation::UrStep>> steps = simulation::read_urscript(damaged);
    if (!steps) continue;
    for (const simulation::UrStep& step : *steps)
      ASSERT_TRUE(std::isfinite(step.speed + step.time_s + step.value)) << "seed 1, case " << i;
  }
}

}  // namespace
}  // namespace pizarra::arm
