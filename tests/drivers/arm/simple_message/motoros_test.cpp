#include <gtest/gtest.h>
#include <numbers>

#include "blackboard/time/virtual_executor.hpp"
#include "drivers/arm/arm_file.hpp"
#include "drivers/arm/route.hpp"
#include "drivers/arm/simple_message/motoros_arm.hpp"
#include "tests/drivers/arm/driven_arm.hpp"
#include "tests/drivers/arm/plain/plain_motoros.hpp"
#include "tests/drivers/line/wire_pair.hpp"

namespace pizarra::arm {
namespace {

const ArmModel& up6() {
  static const ArmModel model = shipped_arm("motoman-up6").value();
  return model;
}

// The driver on a controller that follows points as the published server does, in either byte order.
class Motoros : public testing::TestWithParam<line::ByteOrder>, protected DrivenArm<Motoros> {
  friend DrivenArm<Motoros>;

 protected:
  double place(std::size_t axis) const { return controller.place_rad[axis] * 180 / std::numbers::pi; }

  VirtualExecutor executor;
  PlainMotoros controller{up6(), GetParam()};
  line::WirePair motion{executor}, state{executor};
  Job following{executor.spawn(run_motoros(executor, controller))};
  Job moving{executor.spawn(serve_motion(executor, controller, motion.far))};
  Job telling{executor.spawn(serve_state(executor, controller, state.far))};
  MotorosArm arm{executor, {.motion = motion.near, .state = state.near, .order = GetParam()}, up6()};
};

INSTANTIATE_TEST_SUITE_P(In, Motoros, testing::Values(line::ByteOrder::little, line::ByteOrder::big),
                         [](const auto& order) {
                           return std::string(order.param == line::ByteOrder::little ? "LittleEndian" : "BigEndian");
                         });

TEST_P(Motoros, BeginsTheTrajectoryModeOnlyByTakingControl) {
  ASSERT_TRUE(ask(arm.identify()));
  EXPECT_FALSE(controller.started);
  const Result<ArmReading> before = read();
  ASSERT_TRUE(before && before->trouble);
  EXPECT_EQ(before->trouble->kind, ArmTrouble::Kind::off);
  EXPECT_EQ(move({up6().home}), "not-in-control");
  EXPECT_EQ(outcome(arm.take_control()), "");
  EXPECT_TRUE(controller.started);
  EXPECT_FALSE(read()->trouble);
  EXPECT_EQ(outcome(arm.release_control()), "");
  EXPECT_FALSE(controller.started);
  EXPECT_EQ(move({up6().home}), "not-in-control");
}

TEST_P(Motoros, GoesThroughWaypointsWithoutStandingAsFastAsItIsTold) {
  ASSERT_EQ(connect(), "");
  EXPECT_TRUE(are_same_place(read()->joints, up6().ready));
  const Joints there = moved(0, 40);
  Joints further = there;
  further[5] += 50;
  const Time begun = executor.now();
  ASSERT_EQ(move({there, further}, 0.5), "");
  EXPECT_TRUE(read()->moving);
  const Result<ArmReading> ended = wait();
  ASSERT_TRUE(ended);
  EXPECT_FALSE(ended->stopped);
  EXPECT_TRUE(are_same_place(ended->joints, further));
  EXPECT_NEAR(place(0), further[0], 0.01);
  const double full_s = seconds_between(up6(), up6().ready, there) + seconds_between(up6(), there, further);
  const double took_s = std::chrono::duration<double>(executor.now() - begun).count();
  EXPECT_NEAR(took_s, full_s / 0.5 + 0.125 + 0.04, 0.1);
  EXPECT_LT(controller.longest_still_s, 0.005);
  EXPECT_GT(controller.busy, 0) << "points come while the arm moves";
  for (std::size_t axis = 0; axis < 6; ++axis) {
    EXPECT_LE(controller.fastest_rad_s[axis], 0.53 * up6().axes[axis].speed * std::numbers::pi / 180) << axis;
  }
}

TEST_P(Motoros, AStopEndsTheTrajectoryAndTheNextBeginsWhereItStands) {
  ASSERT_EQ(connect(), "");
  ASSERT_EQ(move({moved(0, 100)}, 0.5), "");
  executor.run_for(400ms);
  EXPECT_EQ(outcome(arm.stop()), "");
  const Result<ArmReading> ended = wait();
  ASSERT_TRUE(ended);
  EXPECT_TRUE(ended->stopped);
  EXPECT_FALSE(ended->why_stopped) << "somebody stopped it";
  const double stands = place(0);
  EXPECT_LT(std::abs(stands - up6().ready[0]), 90);
  executor.run_for(1s);
  EXPECT_EQ(place(0), stands);
  EXPECT_EQ(move({up6().ready}), "");
  EXPECT_TRUE(are_same_place(wait()->joints, up6().ready));
}

// A busy controller is asked again and again: whenever the stop comes, it is the last.
TEST_P(Motoros, NoPointFollowsAStop) {
  ASSERT_EQ(connect(), "");
  for (int after_ms = 300; after_ms < 340; ++after_ms) {
    ASSERT_EQ(move({moved(0, place(0) > 0 ? -100 : 100)}, 0.5), "");
    executor.run_for(std::chrono::milliseconds(after_ms));
    EXPECT_EQ(outcome(arm.stop()), "");
    const int points = controller.points;
    executor.run_for(500ms);
    EXPECT_EQ(controller.points, points) << after_ms;
    EXPECT_FALSE(read()->moving) << after_ms;
  }
}

TEST_P(Motoros, AControllerThatLeavesTheModeEndsTheMoveAndSaysWhy) {
  ASSERT_EQ(connect(), "");
  ASSERT_EQ(move({moved(0, 100)}, 0.5), "");
  executor.run_for(400ms);
  controller.started = false;
  const Result<ArmReading> ended = wait();
  ASSERT_TRUE(ended);
  EXPECT_TRUE(ended->stopped);
  ASSERT_TRUE(ended->why_stopped);
  EXPECT_EQ(ended->why_stopped->symbol, "stopped");
  EXPECT_EQ(connect(), "");
  EXPECT_EQ(move({up6().ready}), "");
}

TEST_P(Motoros, ATrajectoryIsBegunAnewOverALineThatWasLost) {
  ASSERT_EQ(connect(), "");
  ASSERT_EQ(move({moved(0, 100)}, 0.5), "");
  executor.run_for(400ms);
  motion.cut(true);
  executor.run_for(2s);
  motion.cut(false);
  const Result<ArmReading> ended = wait();
  ASSERT_TRUE(ended);
  EXPECT_TRUE(ended->stopped);
  ASSERT_EQ(connect(), "");
  EXPECT_EQ(move({up6().ready}), "");
  EXPECT_TRUE(are_same_place(wait()->joints, up6().ready));
}

TEST(MotorosMessages, WhatIsRefusedIsSaidInWords) {
  EXPECT_EQ(meaning_of({.result = 5, .subcode = 5007}), "the controller is held");
  EXPECT_EQ(meaning_of({.result = 3, .subcode = 3011}), "the trajectory does not begin where the arm stands");
  EXPECT_EQ(meaning_of({.result = 4}), "there is an alarm");
  EXPECT_EQ(meaning_of({.result = 77}), "the controller failed");
}

// As the published server has them, octet by octet.
TEST(MotorosMessages, AreLaidOutAsTheServerHasThem) {
  const std::string command = write_control({.group = 0, .sequence = 7, .command = 200121}, line::ByteOrder::big);
  EXPECT_EQ(command, std::string("\0\0\0\0\0\0\0\7\0\3\x0d\xb9", 12) + std::string(40, '\0'));
  const std::string point = write_motoros_point(MotorosPoint{.sequence = 1, .time_s = 0.5f}, line::ByteOrder::little);
  EXPECT_EQ(point.size(), 136u);
  EXPECT_EQ(point.substr(4, 12), std::string("\1\0\0\0\7\0\0\0\0\0\0\x3f", 12));
  EXPECT_FALSE(read_reply(point, line::ByteOrder::little));
}

}  // namespace
}  // namespace pizarra::arm
