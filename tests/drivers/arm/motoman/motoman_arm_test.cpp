#include "drivers/arm/motoman/motoman_arm.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "tests/drivers/arm/motoman/hses_cell.hpp"

namespace pizarra::arm {
namespace {

class Motoman : public testing::Test, protected HsesCell {
 protected:
  // The tool straight to the side, as the robot agent asks for it: a waypoint every 5 mm.
  std::vector<Joints> line_of(double dy_mm) {
    Joints at = read()->joints;
    const ToolPose begin = forward(up6(), at);
    const int steps = static_cast<int>(std::abs(dy_mm) / 5);
    std::vector<Joints> waypoints;
    for (int i = 1; i <= steps; ++i) {
      ToolPose pose = begin;
      pose.translation().y() += dy_mm * i / steps;
      at = inverse(up6(), pose, at).value();
      waypoints.push_back(at);
    }
    return waypoints;
  }

  line::LossyLine late_line{executor, Random(2), [this](std::string said) { return emulator.answer(std::move(said)); }};
};

TEST_F(Motoman, SaysWhereTheArmIsToAPulseAndTakesControl) {
  ASSERT_EQ(connect(), "");
  const Result<ArmReading> reading = read();
  ASSERT_TRUE(reading);
  EXPECT_TRUE(are_same_place(reading->joints, up6().ready, 0.002));
  EXPECT_FALSE(reading->moving);
  EXPECT_EQ(reading->opening_mm, 100);
}

TEST_F(Motoman, GoesThereInPulsesAndSaysWhenItStands) {
  ASSERT_EQ(connect(), "");
  const Joints there = moved(0, 40);
  EXPECT_EQ(move({there}), "");
  EXPECT_TRUE(read()->moving);
  const Result<ArmReading> ended = wait();
  ASSERT_TRUE(ended);
  EXPECT_FALSE(ended->stopped);
  EXPECT_TRUE(are_same_place(ended->joints, there));
  EXPECT_EQ(cabinet.moves(), 1u);
}

// An order that a network has kept for seconds comes while the arm stands. A controller that cannot tell an old order
// from a new one carries it out.
TEST_F(Motoman, AnOrderThatComesAgainWhileTheArmStandsIsHeldAndTheNextMoveGoesOnFromThere) {
  ASSERT_EQ(connect(), "");
  const Joints first = moved(0, 100);
  ASSERT_EQ(move({first}), "");
  ASSERT_FALSE(wait()->stopped);
  const Joints second = moved(0, -100);
  ASSERT_EQ(move({second}), "");
  ASSERT_FALSE(wait()->stopped);
  HsesLink other(executor, late_line);
  ASSERT_TRUE(ask(other.open(executor.now() + 1s)));
  MotomanPulses old{};
  for (std::size_t axis = 0; axis < first.size(); ++axis) {
    old[axis] = static_cast<std::int32_t>(std::llround(first[axis] * up6().axes[axis].pulses_per_turn / 360));
  }
  ASSERT_TRUE(ask(other.move_joints(old, 1)));
  const Result<ArmReading> held = wait();
  ASSERT_TRUE(held);
  EXPECT_FALSE(are_same_place(held->joints, first, 10));
  ASSERT_TRUE(held->why_stopped);
  EXPECT_EQ(held->why_stopped->symbol, "stopped");
  executor.run_for(1s);
  EXPECT_TRUE(are_same_place(read()->joints, held->joints));
  EXPECT_EQ(move({second}), "");
  const Result<ArmReading> ended = wait();
  EXPECT_FALSE(ended->stopped);
  EXPECT_TRUE(are_same_place(ended->joints, second));
}

TEST_F(Motoman, AStraightLineOfManyWaypointsIsOneLinearMoveAndStraightAllAlong) {
  ASSERT_EQ(connect(), "");
  const ToolPose begin = forward(up6(), read()->joints);
  const std::vector<Joints> waypoints = line_of(250);
  ASSERT_EQ(move(waypoints), "");
  Result<ArmReading> reading = read();
  while (reading && reading->moving) {
    const ToolPose here = forward(up6(), reading->joints);
    EXPECT_NEAR(here.translation().x(), begin.translation().x(), 0.1);
    EXPECT_NEAR(here.translation().z(), begin.translation().z(), 0.1);
    EXPECT_LT(here.linear().col(2).cross(begin.linear().col(2)).norm(), 1e-3);
    executor.run_for(20ms);
    reading = read();
  }
  ASSERT_TRUE(reading);
  EXPECT_NEAR(forward(up6(), reading->joints).translation().y(), begin.translation().y() + 250, 0.1);
  EXPECT_TRUE(are_same_place(reading->joints, waypoints.back(), 0.05));
  EXPECT_EQ(cabinet.moves(), 1u);
}

TEST_F(Motoman, SeveralLegsAreGoneOneAfterAnother) {
  ASSERT_EQ(connect(), "");
  const Joints one = moved(0, 20);
  Joints two = one;
  two[3] += 30;
  ASSERT_EQ(move({one, two, up6().ready}), "");
  const Result<ArmReading> ended = wait();
  ASSERT_TRUE(ended);
  EXPECT_TRUE(are_same_place(ended->joints, up6().ready));
  EXPECT_EQ(cabinet.moves(), 3u);
}

TEST_F(Motoman, GoesAtThePartOfItsSpeedThatWasAskedTimesTheOverride) {
  ASSERT_EQ(connect(), "");
  double side_deg = 60;
  const auto seconds = [&](double speed) {
    const Time begun = executor.now();
    Joints there = up6().ready;
    there[0] = side_deg;
    side_deg = -side_deg;
    EXPECT_EQ(move({there}, speed), "");
    EXPECT_TRUE(wait());
    return std::chrono::duration<double>(executor.now() - begun).count();
  };
  seconds(1);
  // With the ramp at either end, and the polls.
  const auto expected = [](double part) { return 120 / up6().axes[0].speed / part + 0.25 * part; };
  EXPECT_NEAR(seconds(1), expected(1), 0.06);
  EXPECT_NEAR(seconds(0.25), expected(0.25), 0.06);
  ASSERT_TRUE(cabinet.obey("override 50"));
  EXPECT_NEAR(seconds(1), expected(0.5), 0.06);
}

TEST_F(Motoman, RefusesWhatIsBeyondAnAxisOrNoNumberAndSendsNothing) {
  ASSERT_EQ(connect(), "");
  line.sent = 0;
  const Result<void> beyond = ask(arm.start_move({Joints{0, -35, -70, 0, 136, 0}}, 1));
  ASSERT_FALSE(beyond);
  EXPECT_EQ(beyond.error().symbol, "joint-limit");
  EXPECT_EQ(beyond.error().subject, to_datum(5));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(move({Joints{0, nan, -70, 0, 0, 0}}), "not-finite");
  EXPECT_EQ(move({up6().ready}, nan), "not-finite");
  EXPECT_EQ(move({up6().ready}, 1.1), "bad-request");
  EXPECT_EQ(move({}), "bad-request");
  EXPECT_EQ(move({Joints{1e300, 0, 0, 0, 0, 0}}), "joint-limit");
  EXPECT_EQ(move({Joints{0, 0}}), "bad-joints");
  EXPECT_EQ(outcome(arm.start_gripper(nan)), "not-finite");
  EXPECT_EQ(line.sent, 0u);
}

TEST_F(Motoman, AStopBrakesAndHoldsUntilAskedAnew) {
  ASSERT_EQ(connect(), "");
  const Joints there = moved(0, 100);
  ASSERT_EQ(move({there}), "");
  executor.run_for(300ms);
  EXPECT_EQ(outcome(arm.stop()), "");
  const Result<ArmReading> ended = wait();
  ASSERT_TRUE(ended);
  EXPECT_TRUE(ended->stopped);
  EXPECT_TRUE(cabinet.command_hold());
  executor.run_for(5s);
  EXPECT_TRUE(are_same_place(read()->joints, ended->joints));
  EXPECT_EQ(move({there}), "");
  EXPECT_TRUE(are_same_place(wait()->joints, there));
}

TEST_F(Motoman, AStopInTheFirstOfSeveralLegsLeavesTheOthersOut) {
  ASSERT_EQ(connect(), "");
  const Joints there = moved(0, 60);
  ASSERT_EQ(move({there, up6().ready, there}), "");
  executor.run_for(200ms);
  EXPECT_EQ(outcome(arm.stop()), "");
  EXPECT_TRUE(wait()->stopped);
  EXPECT_EQ(cabinet.moves(), 1u);
}

struct Interruption {
  const char* what;
  const char* says;
  const char* undo;
};

// The end of a broken move says why, and the next one is refused until the cause is undone and control taken again.
TEST_F(Motoman, WhatEndsAMoveIsNamedAndMendedOnlyWhenAskedAnew) {
  ASSERT_EQ(connect(), "");
  for (const Interruption& each :
       {Interruption{"estop on", "servos are off", "estop off"}, Interruption{"pendant on", "pendant", "pendant off"},
        Interruption{"hold on", "holds the arm", "hold off"}, Interruption{"alarm 4321", "alarm 4321", nullptr}}) {
    const Joints there = moved(0, read()->joints[0] > 0 ? -60 : 60);
    ASSERT_EQ(move({there}), "") << each.what;
    executor.run_for(200ms);
    ASSERT_TRUE(cabinet.obey(each.what));
    const Result<ArmReading> ended = wait();
    ASSERT_TRUE(ended) << each.what;
    EXPECT_TRUE(ended->stopped) << each.what;
    ASSERT_TRUE(ended->why_stopped) << each.what;
    EXPECT_EQ(ended->why_stopped->symbol, "stopped");
    EXPECT_NE(ended->why_stopped->sentence.find(each.says), std::string::npos) << ended->why_stopped->sentence;
    EXPECT_EQ(move({there}), "not-in-control") << each.what;
    if (each.undo != nullptr) {
      EXPECT_EQ(outcome(arm.take_control()), "not-in-control") << each.what;
      ASSERT_TRUE(cabinet.obey(each.undo));
    }
    executor.run_for(2s);
    EXPECT_TRUE(are_same_place(read()->joints, ended->joints)) << each.what << ": it went on by itself";
    EXPECT_EQ(outcome(arm.take_control()), "") << each.what;
    EXPECT_EQ(move({there}), "") << each.what;
    EXPECT_TRUE(are_same_place(wait()->joints, there)) << each.what;
  }
}

TEST_F(Motoman, ItsServosGoOffWhereControlIsReleased) {
  ASSERT_EQ(connect(), "");
  EXPECT_EQ(outcome(arm.release_control()), "");
  EXPECT_EQ(outcome(arm.release_control()), "") << "they are off already";
  EXPECT_EQ(move({moved(0, 60)}), "not-in-control");
  EXPECT_EQ(outcome(arm.take_control()), "");
  EXPECT_EQ(move({moved(0, 60)}), "");
}

TEST_F(Motoman, PowerThatIsLostInMidMoveIsSilenceAndThenAnAlarm) {
  ASSERT_EQ(connect(), "");
  ASSERT_EQ(move({moved(0, 100)}), "");
  executor.run_for(300ms);
  ASSERT_TRUE(cabinet.obey("power off"));
  const Result<ArmReading> silent = read();
  ASSERT_FALSE(silent);
  EXPECT_EQ(silent.error().symbol, "disconnected");
  EXPECT_EQ(move({up6().ready}), "busy");
  ASSERT_TRUE(cabinet.obey("power on"));
  const Result<ArmReading> back = wait();
  ASSERT_TRUE(back);
  EXPECT_TRUE(back->stopped);
  EXPECT_EQ(back->why_stopped->subject, to_datum(simulation::ArmCabinet::power_lost_alarm));
  EXPECT_EQ(connect(), "");
  EXPECT_EQ(move({up6().ready}), "");
  EXPECT_TRUE(are_same_place(wait()->joints, up6().ready));
}

TEST_F(Motoman, AControllerThatIsNotThereFailsWithinASecondAndASentence) {
  line.pulled = true;
  EXPECT_EQ(connect(), "disconnected");
  line.pulled = false;
  ASSERT_EQ(connect(), "");
  line.pulled = true;
  const Time before = executor.now();
  const Result<ArmReading> reading = read();
  ASSERT_FALSE(reading);
  EXPECT_EQ(reading.error().symbol, "disconnected");
  EXPECT_LE(executor.now() - before, 1s);
}

TEST_F(Motoman, RepliesThatAreNotWhatWasAskedAreOneClearFailure) {
  ASSERT_EQ(connect(), "");
  line.from_device = [](std::string said) {
    Result<HsesReply> reply = read_hses_reply(said);
    reply->data.resize(reply->data.size() / 2);
    return write_hses(*reply);
  };
  const Result<ArmReading> half = read();
  ASSERT_FALSE(half);
  EXPECT_EQ(half.error().symbol, "bad-reply");
  EXPECT_NE(half.error().sentence.find("4 octets instead of 8"), std::string::npos) << half.error().sentence;
  line.from_device = [](std::string) { return std::string("\xff\0 garbage", 10); };
  EXPECT_EQ(read().error().symbol, "disconnected");
  line.from_device = nullptr;
  EXPECT_TRUE(read());
}

TEST_F(Motoman, TheGripperIsHeldToItsVariables) {
  ASSERT_EQ(connect(), "");
  EXPECT_EQ(outcome(arm.start_gripper(40)), "");
  EXPECT_TRUE(read()->gripper_moving);
  EXPECT_NEAR(wait_for_gripper()->opening_mm, 40, 0.01);
}

TEST_F(Motoman, AnArmWhosePulsesItsFileDoesNotSayIsRefused) {
  ArmModel bare = up6();
  bare.axes[2].pulses_per_turn = 0;
  MotomanArm other(executor, link, bare);
  const Result<std::string> type = ask(other.identify());
  ASSERT_FALSE(type);
  EXPECT_EQ(type.error().symbol, "bad-arm");
  EXPECT_EQ(type.error().subject, to_datum(3));
}

TEST_F(Motoman, AnArmWithAnAxisMoreIsNotTakenForOneWithout) {
  ASSERT_EQ(connect(), "");
  ASSERT_EQ(move({moved(5, 20)}), "");
  ASSERT_TRUE(wait());
  ArmModel shorter = up6();
  shorter.axes.pop_back();
  MotomanArm other(executor, link, shorter);
  const Result<std::string> type = ask(other.identify());
  ASSERT_FALSE(type);
  EXPECT_EQ(type.error().symbol, "unknown-arm") << type.error().sentence;
}

// Over a line that loses a fifth and repeats a tenth, every target is gone to once, in order, and none beside.
TEST(MotomanOverABadLine, EveryMoveIsCarriedOutExactlyOnce) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    HsesCell cell(seed);
    cell.line.loss = 0.2;
    cell.line.duplication = 0.1;
    cell.line.longest_delay = 10ms;
    ASSERT_EQ(cell.connect(), "") << "seed " << seed;
    Random random(seed);
    for (std::uint64_t i = 1; i <= 50; ++i) {
      Joints there = up6().ready;
      for (double& axis : there) axis += random.uniform(-5, 5);
      ASSERT_EQ(cell.move({there}), "") << "seed " << seed << ", move " << i;
      const Result<ArmReading> ended = cell.wait();
      ASSERT_TRUE(ended) << "seed " << seed << ", move " << i << ": " << ended.error().sentence;
      ASSERT_FALSE(ended->stopped) << "seed " << seed << ", move " << i;
      ASSERT_TRUE(are_same_place(ended->joints, there)) << "seed " << seed << ", move " << i;
      ASSERT_EQ(cell.cabinet.moves(), i) << "seed " << seed;
      ASSERT_TRUE(are_same_place(cell.cabinet.last_target(), there)) << "seed " << seed << ", move " << i;
    }
    EXPECT_GT(cell.line.lost, 100u);
    EXPECT_GT(cell.line.repeated, 50u);
  }
}

}  // namespace
}  // namespace pizarra::arm
