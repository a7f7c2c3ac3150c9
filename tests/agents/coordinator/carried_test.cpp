#include "agents/coordinator/act/carried.hpp"

#include <algorithm>
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

// Fingers that hold something close no further.
TEST_F(Carrying, NoticesASlipBeforeTheFingersHaveClosedFar) {
  carry_circle();
  cell.motion_takes = 5s;
  ASSERT_TRUE(cell.run_until("(request ? robot (turn ? ?))", 1s));
  cell.slip(54);
  EXPECT_TRUE(cell.run_until("(request ? robot (finish stop ?))", 300ms));
}

TEST_F(Carrying, StaysLowUntilItHasGraspedAgainWhatSlipped) {
  carry_circle();
  cell.slip();
  ASSERT_TRUE(cell.run_until("(operation ? (PICK-UP circle) running)", 3s));
  double highest_mm = 0;
  while (cell.opening_mm != 60 && highest_mm < 300) {
    highest_mm = std::max(highest_mm, cell.grip.z());
    cell.run_for(50ms);
  }
  EXPECT_LT(highest_mm, 150);
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

// A cube that met something may hang askew, lower than it was gripped.
TEST_F(Carrying, TravelsHighOnceAStepHasFailed) {
  carry_circle();
  cell.refusal = "stopped";
  ASSERT_TRUE(cell.run_until("(operation ? (STACK circle square) failed)", 10s));
  cell.refusal.clear();
  double highest_mm = 0;
  for (int i = 0; i < 100 && cell.opening_mm == 60; ++i) {
    highest_mm = std::max(highest_mm, cell.grip.z());
    cell.run_for(50ms);
  }
  EXPECT_NEAR(highest_mm, 300, 3);
  EXPECT_TRUE(cell.run_until("(goal-state 1 reached ?)", 60s));
}

// The fingers hold the cube, though the border of the images cuts it off.
TEST_F(Carrying, HoldsWhatItCarriesPastTheBorderOfTheImages) {
  cell.cubes["square"] = {450, -300, 30};
  cell.covered = [this](const std::string& name) { return cell.held == name && cell.cubes[name].y() < -250; };
  cell.motion_takes = 700ms;
  cell.request("coordinator", "(goal (on circle square))");
  ASSERT_TRUE(cell.run_until("(goal-state 1 reached ?)", 60s));
  EXPECT_TRUE(cell.facts("(event ? difference ? ?)").empty());
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
