#include "drivers/arm/simple_message/simple_arm.hpp"

#include <gtest/gtest.h>
#include <limits>

#include "blackboard/time/random.hpp"
#include "blackboard/time/virtual_executor.hpp"
#include "drivers/arm/arm_file.hpp"
#include "drivers/simulation/controllers/arms/moving_arm.hpp"
#include "drivers/simulation/controllers/arms/simple_emulator.hpp"
#include "tests/drivers/arm/driven_cells.hpp"
#include "tests/drivers/line/wire_pair.hpp"

namespace pizarra::arm {
namespace {

struct Line {
  const char* name;
  simulation::SimpleKind kind;
};

// Over TCP in either order of octets, and over the C500C's serial lines.
class Simple : public testing::TestWithParam<Line>, protected SimpleCell {
 protected:
  Simple() : SimpleCell(GetParam().kind) {}
};

INSTANTIATE_TEST_SUITE_P(Over, Simple,
                         testing::Values(Line{"TcpLittleEndian", {}},
                                         Line{"TcpBigEndian", {.order = line::ByteOrder::big}},
                                         Line{"C500CSerial", {.serial = true, .sign = -1}},
                                         Line{"C500CAtAFifth", {.serial = true, .sign = -1, .fixed_speed = 0.2}},
                                         Line{"TcpWithTheTrack", {.track = true}}),
                         [](const auto& line) { return std::string(line.param.name); });

TEST_P(Simple, ReadsWhereTheArmIsAndGoesWhereItIsSent) {
  ASSERT_EQ(connect(), "");
  EXPECT_TRUE(are_same_place(read()->joints, crs_f3().ready));
  const Joints there = moved(0, 30);
  Joints further = there;
  further[4] += 20;
  EXPECT_EQ(outcome(arm.start_move({there, further}, 0.5)), "");
  EXPECT_TRUE(read()->moving);
  const Result<ArmReading> ended = wait();
  ASSERT_TRUE(ended);
  EXPECT_FALSE(ended->stopped);
  EXPECT_TRUE(are_same_place(ended->joints, further));
  EXPECT_EQ(cabinet.moves(), 2u);
}

TEST_P(Simple, AnArmWithAnAxisMoreIsNotTakenForOneWithout) {
  ASSERT_EQ(connect(), "");
  ASSERT_EQ(move({moved(5, 20)}), "");
  ASSERT_TRUE(wait());
  ArmModel shorter = crs_f3();
  shorter.axes.resize(5);
  shorter.ready = {0, 0, -90, 0, -90};
  replace(arm, executor, wires, shorter);
  const Result<std::string> type = ask(arm.identify());
  ASSERT_FALSE(type);
  EXPECT_EQ(type.error().symbol, "unknown-arm") << type.error().sentence;
}

TEST_P(Simple, AStopBrakesAndLeavesTheOtherPointsOut) {
  ASSERT_EQ(connect(), "");
  ASSERT_EQ(outcome(arm.start_move({moved(0, 100), crs_f3().ready}, 1)), "");
  executor.run_for(300ms);
  EXPECT_EQ(outcome(arm.stop()), "");
  const Result<ArmReading> ended = wait();
  ASSERT_TRUE(ended);
  EXPECT_TRUE(ended->stopped);
  EXPECT_EQ(cabinet.moves(), 1u);
  EXPECT_EQ(outcome(arm.start_move({crs_f3().ready}, 1)), "");
  EXPECT_TRUE(are_same_place(wait()->joints, crs_f3().ready));
}

TEST_P(Simple, WhatEndsAMoveIsNamedAndRefusesTheNext) {
  ASSERT_EQ(connect(), "");
  struct Case {
    const char* what;
    const char* says;
    const char* undo;
  };
  for (const Case& each : {Case{"estop on", "emergency", "estop off"}, Case{"pendant on", "pendant", "pendant off"},
                           Case{"alarm 17", "error", "alarm 0"}}) {
    ASSERT_EQ(outcome(arm.start_move({moved(0, read()->joints[0] > 0 ? -60 : 60)}, 1)), "") << each.what;
    executor.run_for(250ms);
    ASSERT_TRUE(cabinet.obey(each.what));
    const Result<ArmReading> ended = wait();
    ASSERT_TRUE(ended);
    ASSERT_TRUE(ended->why_stopped) << each.what;
    EXPECT_NE(ended->why_stopped->sentence.find(each.says), std::string::npos) << ended->why_stopped->sentence;
    EXPECT_EQ(outcome(arm.start_move({crs_f3().ready}, 1)), "not-in-control") << each.what;
    ASSERT_TRUE(cabinet.obey(each.undo));
    ASSERT_TRUE(cabinet.obey("servo on"));
    executor.run_for(1s);
    EXPECT_EQ(outcome(arm.take_control()), "") << each.what;
  }
}

TEST_P(Simple, RefusesWhatItsAxesCannot) {
  ASSERT_EQ(connect(), "");
  motion.near.written.clear();
  const Result<void> beyond = ask(arm.start_move({moved(2, 300)}, 1));
  EXPECT_EQ(beyond.error().symbol, "joint-limit");
  EXPECT_EQ(beyond.error().subject, to_datum(3));
  EXPECT_EQ(outcome(arm.start_move({moved(2, std::numeric_limits<double>::infinity())}, 1)), "not-finite");
  EXPECT_EQ(outcome(arm.start_gripper(40)), "refused") << "the protocol has none";
  EXPECT_EQ(motion.near.written, "");
}

TEST_P(Simple, ALostPowerOrACutLineLeavesNothingKnown) {
  ASSERT_EQ(connect(), "");
  ASSERT_EQ(outcome(arm.start_move({moved(0, 100)}, 1)), "");
  executor.run_for(200ms);
  ASSERT_TRUE(cabinet.obey("power off"));
  executor.run_for(600ms);
  EXPECT_EQ(read().error().symbol, "disconnected");
  ASSERT_TRUE(cabinet.obey("power on"));
  executor.run_for(100ms);
  EXPECT_TRUE(wait()->stopped);
  state.cut(true);
  executor.run_for(600ms);
  EXPECT_EQ(read().error().symbol, "disconnected");
  state.cut(false);
  ASSERT_TRUE(cabinet.obey("alarm 0"));
  ASSERT_TRUE(cabinet.obey("servo on"));
  executor.run_for(1s);
  EXPECT_EQ(connect(), "");
}

TEST_P(Simple, AnAcknowledgementThatDoesNotComeEndsTheMotionInAFailure) {
  ASSERT_EQ(connect(), "");
  motion.far.spoil = [](std::string) { return std::string(); };
  const Time before = executor.now();
  EXPECT_EQ(outcome(arm.start_move({moved(0, 10)}, 1)), "disconnected");
  EXPECT_LE(executor.now() - before, 2s);
}

TEST_P(Simple, AStopWaitsForNoAcknowledgementThatIsStillToCome) {
  ASSERT_EQ(connect(), "");
  motion.far.spoil = [](std::string) { return std::string(); };
  std::optional<Result<void>> sent, stopped;
  const Job sending = executor.spawn(keep(arm.start_move({moved(0, 60)}, 1), sent));
  executor.run_for(50ms);
  ASSERT_TRUE(read()->moving);
  const Job stopping = executor.spawn(keep(arm.stop(), stopped));
  executor.run_for(250ms);
  EXPECT_FALSE(read()->moving);
}

TEST_P(Simple, AStopFindsAMotionLineThatWasLost) {
  ASSERT_EQ(connect(), "");
  ASSERT_EQ(move({moved(0, 100)}), "");
  executor.run_for(100ms);
  motion.far.close();
  EXPECT_EQ(outcome(arm.stop()), "");
  EXPECT_TRUE(wait()->stopped);
}

TEST_P(Simple, TheTrackIsAJointWhereTheControllerHasIt) {
  ASSERT_EQ(connect(), "");
  const std::size_t track = crs_f3().axis_of(Role::track).value();
  Joints there = moved(track, 750);
  there[0] += 20;
  const Result<void> sent = ask(arm.start_move({there}, 1));
  if (!kind.track) {
    ASSERT_FALSE(sent);
    EXPECT_EQ(sent.error().symbol, "bad-request");
    EXPECT_EQ(sent.error().subject, to_datum(track + 1));
    EXPECT_EQ(cabinet.moves(), 0u);
    return;
  }
  ASSERT_TRUE(sent) << describe(sent.error());
  const Result<ArmReading> ended = wait();
  ASSERT_TRUE(ended);
  EXPECT_FALSE(ended->stopped);
  EXPECT_TRUE(are_same_place(ended->joints, there, 0.01));
  EXPECT_TRUE(are_same_place(ask(cabinet.read()).joints, there, 0.01));
}

// Over serial lines that garble, no reading is false and every move that is said to have ended ended there.
TEST(SimpleOverABadLine, NoReadingIsFalse) {
  VirtualExecutor executor;
  simulation::MovingArm body(executor, crs_f3());
  simulation::ArmCabinet cabinet(executor, body, crs_f3());
  simulation::SimpleEmulator emulator(cabinet, {.serial = true});
  line::WirePair motion(executor), state(executor);
  const Job moving = executor.spawn(simulation::serve_motion(executor, emulator, motion.far));
  const Job telling = executor.spawn(simulation::serve_state(executor, emulator, state.far));
  SimpleArm arm(executor, {motion.near, state.near, true}, crs_f3());
  ASSERT_TRUE(run(executor, arm.identify()));
  Random random(1);
  state.far.spoil = [&random](std::string octets) {
    for (char& octet : octets) {
      if (random.uniform(0, 1) < 0.002) octet = static_cast<char>(random.below(256));
    }
    return octets;
  };
  int readings = 0;
  for (int i = 0; i < 300; ++i) {
    executor.run_for(50ms);
    const Result<ArmReading> reading = run(executor, arm.read());
    if (!reading) continue;
    ++readings;
    ASSERT_TRUE(are_same_place(reading->joints, crs_f3().ready, 0.05)) << "seed 1, reading " << i;
  }
  EXPECT_GT(readings, 100);
}

}  // namespace
}  // namespace pizarra::arm
