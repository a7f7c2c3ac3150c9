#include <algorithm>

#include "tests/agents/coordinator/coordinator_fixture.hpp"

namespace pizarra::coordinator {
namespace {

TEST_F(Coordinator, PushesWhatCannotBeGraspedAlsoWhereTheFingersMeetOnAnEdge) {
  cell.lowest_mm = 60;
  cell.jam_mm = 40;
  want("(goal (holding circle))");
  EXPECT_TRUE(cell.run_until("(event ? servo \"circle cannot be grasped as it lies: pushing it\" ?)", 60s));
}

TEST_F(Coordinator, PushesNoFasterThanTheOperatorSaidAndLeavesThatSpeedAsItWas) {
  cell.lowest_mm = 60;
  cell.jam_mm = 40;
  cell.tell("(robot-speed robot 10)");
  want("(goal (holding circle))");
  ASSERT_TRUE(cell.run_until("(event ? servo \"circle cannot be grasped as it lies: pushing it\" ?)", 60s));
  cell.run_for(20s);
  const int speeds = cell.times_told("(request ? robot (speed ?))");
  EXPECT_GT(speeds, 0);
  EXPECT_EQ(cell.times_told("(request ? robot (speed 10.0))"), speeds);
}

TEST_F(Coordinator, PushesWhatCannotBeGraspedAlsoWhereTheFingersJamWiderThanACube) {
  cell.lowest_mm = 60;
  cell.jam_mm = 85;
  want("(goal (holding circle))");
  EXPECT_TRUE(cell.run_until("(event ? servo \"circle cannot be grasped as it lies: pushing it\" ?)", 60s));
}

// They press on a neighbour, wide open, and cannot close.
TEST_F(Coordinator, PushesWhatCannotBeGraspedAlsoWhereTheFingersMoveOnlyOnceTheyAreRaised) {
  cell.lowest_mm = 60;
  cell.jam_mm = 96;
  want("(goal (holding circle))");
  EXPECT_TRUE(cell.run_until("(event ? servo \"circle cannot be grasped as it lies: pushing it\" ?)", 60s));
}

TEST_F(Coordinator, SweepsWhatCannotBeGraspedAtTheSideOfTheImagesToWhereItShows) {
  cell.cubes["circle"] = {450, -290, 30};
  cell.lowest_mm = 60;
  want("(goal (holding circle))");
  ASSERT_TRUE(cell.run_until("(event ? servo \"circle cannot be grasped as it lies: pushing it\" ?)", 60s));
  cell.run_for(5s);
  EXPECT_GT(cell.cubes["circle"].y(), -260);
}

// Pushed towards the camera, the face around its mark would be cut off below.
TEST_F(Coordinator, PushesACubeNearTheCameraAwayFromIt) {
  cell.cubes["circle"] = {540, 19, 30};
  cell.lowest_mm = 60;
  want("(goal (holding circle))");
  ASSERT_TRUE(cell.run_until("(event ? servo \"circle cannot be grasped as it lies: pushing it\" ?)", 60s));
  double furthest_mm = 0;
  for (int i = 0; i < 30; ++i) {
    cell.run_for(100ms);
    furthest_mm = std::max(furthest_mm, cell.grip.x());
  }
  EXPECT_GT(furthest_mm, 580);
}

TEST_F(Coordinator, PushesNothingOverWhileTheGrippersSensorIsStuck) {
  cell.lowest_mm = 60;
  cell.stuck_mm = 80;
  want("(goal (holding circle))");
  EXPECT_TRUE(cell.run_until("(event ? servo \"the gripper says 80 mm, closed or open\" ?)", 60s));
  EXPECT_TRUE(cell.facts("(event ? servo \"circle cannot be grasped as it lies: pushing it\" ?)").empty());
  cell.lowest_mm = 0;
  cell.stuck_mm.reset();
  EXPECT_TRUE(cell.run_until("(goal-state 1 reached ?)", 60s));
}

TEST_F(Coordinator, LaysDownWhatItHoldsOutOfSightOnceNobodyStopsItAnyMore) {
  want("(goal (holding circle))");
  ASSERT_TRUE(cell.run_until("(goal-state 1 reached ?)", 60s));
  cell.hidden.insert("circle");
  ASSERT_TRUE(cell.run_until("(believed (arm-empty))", 60s));
  cell.refusal = "halted";
  want("(goal (on circle square))");
  ASSERT_TRUE(
      cell.run_until("(event ? agent \"held up: the test has the robot refuse; the goal goes on when that is "
                     "over\" ?)",
                     30s));
  cell.refusal.clear();
  ASSERT_TRUE(cell.run_until("(event ? servo \"laying down what the gripper holds\" ?)", 60s));
  cell.hidden.clear();
  EXPECT_TRUE(cell.run_until("(goal-state 2 reached ?)", 60s));
}

// Held askew it counts as neither held nor lying anywhere, so that there is no plan until it is laid down.
TEST_F(Coordinator, CallsNothingImpossibleWhileItCannotLayDownWhatItHoldsAskew) {
  want("(goal (holding circle))");
  ASSERT_TRUE(cell.run_until("(goal-state 1 reached ?)", 60s));
  cell.cubes["circle"].x() += 60;
  cell.jam_mm = 60;
  ASSERT_TRUE(cell.run_until("(believed (arm-empty))", 10s));
  cell.refusal = "stopped";
  want("(goal (on circle triangle))");
  cell.run_for(6s);
  EXPECT_GT(cell.times_told("(request ? planner (make-plan ? ? ? ? ?))"), 2);
  EXPECT_TRUE(cell.facts("(goal-state 2 refused ?)").empty());
  cell.refusal.clear();
  ASSERT_TRUE(cell.run_until("(goal-state 2 reached ?)", 90s));
  expect_on("circle", "triangle");
}

TEST_F(Coordinator, SetsAsideWhatHidesTheGrippersMarkAgainAndAgain) {
  cell.tells_pose = false;
  cell.cubes["square"] = {545, -150, 30};
  cell.mark_hidden = [this] {
    const Eigen::Vector3d before = cell.cubes["square"] - cell.grip;
    return cell.grip.z() < 110 && before.x() > 40 && std::abs(before.y()) < 50;
  };
  want("(goal (on circle triangle))");
  ASSERT_TRUE(cell.run_until("(goal-state 1 reached ?)", 180s));
  expect_on("circle", "triangle");
  EXPECT_EQ(cell.times_told("(operation ? (PICK-UP circle) failed)"), 2);
}

TEST_F(Coordinator, NoticesAtOnceThatTheRaisedArmLeftACubeWhereItLay) {
  want("(goal (on circle triangle))");
  ASSERT_TRUE(cell.run_until("(gripper robot 60.0)", 60s));
  cell.held.clear();
  ASSERT_TRUE(cell.run_until("(micro-task ? (raise) running)", 5s));
  EXPECT_TRUE(cell.run_until("(micro-task ? (check-held circle) failed)", 800ms));
  ASSERT_TRUE(cell.run_until("(goal-state 1 reached ?)", 90s));
}

}  // namespace
}  // namespace pizarra::coordinator
