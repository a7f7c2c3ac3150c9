#include "agents/coordinator/act/carried.hpp"

#include <gtest/gtest.h>

#include "tests/agents/coordinator/fake_cell.hpp"

namespace pizarra::coordinator {
namespace {

class Carrying : public testing::Test {
 protected:
  Carrying() { cell.start_coordinator(); }
  // Until the arm is on its way to the square with the circle.
  void carry_circle() {
    cell.request("coordinator", "(goal (on circle square))");
    EXPECT_TRUE(cell.run_until("(operation ? (STACK circle square) running)", 60s));
    EXPECT_TRUE(cell.run_until("(servo ? square ? ? ?)", 10s));
  }

  FakeCell cell{"blocks.scm", {{"circle", {450, -150, 30}}, {"square", {450, 50, 30}}}};
};

TEST_F(Carrying, EndsTheMotionAsSoonAsTheFingersHoldNothingAndGraspsTheCubeAgain) {
  carry_circle();
  cell.motion_takes = 5s;
  ASSERT_TRUE(cell.run_until("(request ? robot (turn ? ?))", 1s));
  cell.slip();
  EXPECT_TRUE(cell.run_until("(request ? robot (finish stop ?))", 300ms));
  cell.motion_takes = 300ms;
  EXPECT_TRUE(cell.run_until("(operation ? (PICK-UP circle) running)", 3s));
  EXPECT_TRUE(cell.run_until("(goal-state 1 reached ?)", 60s));
  EXPECT_FALSE(cell.facts("(event ? difference ? ((holding circle)))").empty());
}

// It slips as it is lifted, again and again: it does not lie badly.
TEST_F(Carrying, PushesNothingThatSlips) {
  cell.request("coordinator", "(goal (on circle square))");
  for (int i = 0; i < 8; ++i) {
    ASSERT_TRUE(cell.run_until("(gripper robot 60.0)", 60s)) << i;
    cell.run_for(150ms);
    cell.slip();
    ASSERT_TRUE(cell.run_until("(operation ? (PICK-UP circle) failed)", 1s)) << i;
    ASSERT_TRUE(cell.run_until("(operation ? (PICK-UP circle) running)", 5s)) << i;
  }
  EXPECT_TRUE(cell.facts("(event ? servo \"circle cannot be grasped as it lies: pushing it\" ?)").empty());
  EXPECT_TRUE(cell.run_until("(goal-state 1 reached ?)", 60s));
}

TEST_F(Carrying, TravelsNoHigherThanItTakesToPassOverWhatStands) {
  carry_circle();
  EXPECT_GT(cell.grip.z(), 60 + 30 + 20);
  EXPECT_LT(cell.grip.z(), 150);
  ASSERT_TRUE(cell.run_until("(goal-state 1 reached ?)", 60s));
  EXPECT_NEAR(cell.grip.z(), 300, 3);
}

// It may be a pile that stands where the eyes do not see it.
TEST_F(Carrying, TravelsHighWhileAnObjectIsNotSeen) {
  cell.cubes["cross"] = {450, 150, 30};
  cell.stop_coordinator();
  cell.hidden.insert("cross");
  cell.start_coordinator();
  carry_circle();
  EXPECT_NEAR(cell.grip.z(), 300, 3);
}

}  // namespace
}  // namespace pizarra::coordinator
