// A jog lasts while its client holds on, and no longer.

#include <numbers>

#include "agents/robot/jog.hpp"
#include "tests/agents/robot/robot_fixture.hpp"

namespace pizarra::robot {
namespace {

class HeldJog : public Robot {
 protected:
  static constexpr Duration renewal = 50ms;

  void tell(std::string_view teller, const std::string& fact) {
    Transaction telling;
    telling.tell(form(fact));
    const Result<Revision> told = board.transact(std::string(teller), telling);
    ASSERT_TRUE(told) << told.error().sentence;
  }
  void hold() { tell("user", fmt::format("(hold robot user {})", ++count_)); }
  void hold_for(Duration time) {
    for (Duration held{}; held < time; held += renewal) {
      hold();
      executor.run_for(renewal);
    }
  }
  void let_go() {
    Transaction retraction;
    retraction.retract(form("(hold robot user ?)"));
    ASSERT_TRUE(board.transact("user", retraction));
  }
  std::string begin_jog(std::string_view direction, int deadline_ms = 250) {
    hold();
    return ask(fmt::format("(jog {} {})", direction, deadline_ms));
  }

 private:
  int count_ = 0;
};

TEST_F(HeldJog, MovesWhileItIsHeldAndStandsWhenLetGoWithoutAStop) {
  const Eigen::Vector3d start = point();
  const std::string id = begin_jog("right");
  hold_for(1s);
  EXPECT_TRUE(arm.moving());
  EXPECT_EQ(reply(id), "");
  let_go();
  executor.run_for(50ms);
  EXPECT_FALSE(arm.moving());
  EXPECT_EQ(reply(id), "(ok true)");
  EXPECT_EQ(first("(arm robot ?state ?action)", 2), "idle");
  EXPECT_EQ(fact("(stop ?who ?why)"), "");
  const Eigen::Vector3d way = point() - start;
  EXPECT_GT(way.y(), 20);
  EXPECT_LT(way.y(), 30);
  EXPECT_NEAR(way.x(), 0, 0.1);
  EXPECT_NEAR(way.z(), 0, 0.1);
}

TEST_F(HeldJog, SilenceStopsItAtItsDeadline) {
  const std::string id = begin_jog("down", 400);
  hold_for(500ms);
  // The last hold is 50 ms old.
  executor.run_for(330ms);
  EXPECT_TRUE(arm.moving());
  executor.run_for(70ms);
  EXPECT_FALSE(arm.moving());
  EXPECT_EQ(reply(id), "(fail stopped \"user has not renewed its hold for 400 ms\" user)");
  EXPECT_EQ(first("(arm robot ?state ?action)", 2), "stopped");
}

TEST_F(HeldJog, ALateBurstOfHoldsMovesNothing) {
  begin_jog("up");
  hold_for(200ms);
  executor.run_for(1s);
  const int moves = arm.moves;
  for (int i = 0; i < 10; ++i) hold();
  executor.run_for(1s);
  EXPECT_FALSE(arm.moving());
  EXPECT_EQ(arm.moves, moves);
}

TEST_F(HeldJog, WhoDoesNotHoldOnMovesNothing) {
  EXPECT_EQ(refusal("(jog left 250)"), "not-held");
  hold();
  executor.run_for(300ms);
  EXPECT_EQ(refusal("(jog left 250)"), "not-held") << "a hold that is older than the deadline";
  tell("another", "(hold robot user 77)");
  EXPECT_EQ(refusal("(jog left 250)"), "not-held") << "another's word";
  EXPECT_EQ(arm.moves, 0);
}

TEST_F(HeldJog, AStopEndsItAsAnyMotion) {
  const std::string id = begin_jog("out");
  hold_for(200ms);
  tell("passer-by", "(stop passer-by \"mind the dog\")");
  hold_for(100ms);
  EXPECT_FALSE(arm.moving());
  EXPECT_TRUE(reply(id).starts_with("(fail stopped \"passer-by says stop")) << reply(id);
}

TEST_F(HeldJog, SaysWhichDeadlinesAndDirectionsThereAre) {
  EXPECT_EQ(refusal("(jog left 249)"), "out-of-range");
  EXPECT_EQ(refusal("(jog left 601)"), "out-of-range");
  hold();
  EXPECT_EQ(refusal("(jog sideways 250)"), "wrong-direction");
}

TEST_F(HeldJog, EndsWhereTheArmReachesNoFurther) {
  const std::string id = begin_jog("tool-up", 250);
  hold_for(60s);
  EXPECT_EQ(reply(id), "(ok true)");
  const std::string again = begin_jog("tool-up", 250);
  hold_for(200ms);
  EXPECT_EQ(reply(again), "(ok false)");
}

TEST_F(HeldJog, EndsAtTheWallsOfItsRoom) {
  life.reset();
  executor.run_for(3s);
  const Eigen::Vector3d at = point();
  const Eigen::Vector3d margin(200, 40, 200);
  life.emplace(executor, board, arm, arm::crs_f3(), RobotOptions{.room = WorkVolume{at - margin, at + margin}});
  executor.run_for(3s);
  const std::string id = begin_jog("right", 250);
  hold_for(5s);
  EXPECT_EQ(reply(id), "(ok true)");
  EXPECT_LE(point().y(), at.y() + 40);
  EXPECT_GT(point().y(), at.y() + 30);
}

// From the last hold to where it stands, whatever the direction, the deadline and the place.
TEST_F(HeldJog, StandsWithinTenMillimetresOfTheLastHold) {
  for (const std::string_view direction :
       {"left", "right", "up", "down", "out", "in", "turn-left", "turn-right", "tool-down", "wrist-left"}) {
    for (const int deadline_ms : {250, 600}) {
      ASSERT_EQ(call("(ready)"), "(ok true)");
      const std::string id = begin_jog(direction, deadline_ms);
      hold_for(1s);
      hold();
      const arm::ToolPose last = arm::forward(arm::crs_f3(), arm.at());
      ASSERT_TRUE(arm.moving()) << direction << ": " << reply(id);
      executor.run_for(std::chrono::milliseconds(deadline_ms + 50));
      EXPECT_FALSE(arm.moving()) << direction;
      const arm::ToolPose stands = arm::forward(arm::crs_f3(), arm.at());
      EXPECT_LE((stands.translation() - last.translation()).norm(), 10) << direction << " " << deadline_ms;
      const Eigen::AngleAxisd turned(last.linear().transpose() * stands.linear());
      EXPECT_LE(turned.angle() * 180 / std::numbers::pi, 10) << direction << " " << deadline_ms;
    }
  }
}

TEST_F(HeldJog, IsNeverFasterThanTheSpeedThatIsSet) {
  ASSERT_EQ(call("(speed 1)"), "(ok true)");
  begin_jog("wrist-left");
  hold_for(200ms);
  EXPECT_LE(arm.last_speed, 0.01);
}

}  // namespace
}  // namespace pizarra::robot
