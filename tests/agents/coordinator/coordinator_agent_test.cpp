#include <algorithm>
#include <gtest/gtest.h>

#include "lisp/writer.hpp"
#include "tests/agents/coordinator/fake_cell.hpp"

namespace pizarra::coordinator {
namespace {

FakeCell::Cubes row() { return {{"circle", {450, -150, 30}}, {"triangle", {455, -50, 30}}, {"square", {445, 50, 30}}}; }

class Coordinator : public testing::Test {
 protected:
  Coordinator() { cell.start_coordinator(); }
  void expect_on(const std::string& upper, const std::string& lower) {
    const Eigen::Vector3d apart = cell.cubes[upper] - cell.cubes[lower];
    EXPECT_LT(std::hypot(apart.x(), apart.y()), 4) << upper;
    EXPECT_NEAR(apart.z(), 60, 1) << upper;
  }
  std::string want(std::string_view goal) { return write(cell.request("coordinator", goal)); }

  FakeCell cell{"blocks.scm", row()};
};

TEST_F(Coordinator, BuildsWhatIsWanted) {
  EXPECT_EQ(want("(goal (on circle triangle) (on triangle square))"), "(ok 1)");
  ASSERT_TRUE(cell.run_until("(goal-state 1 reached ?)", 120s));
  expect_on("circle", "triangle");
  expect_on("triangle", "square");
  EXPECT_TRUE(cell.facts("(event ? difference ? ?)").empty());
  EXPECT_EQ(cell.times_told("(plan 1 ?)"), 1);
  EXPECT_EQ(cell.facts("(on ? ?)").size(), 2U);
  for (int state = 1; state <= 4; ++state)
    EXPECT_GT(cell.times_told("(servo " + std::to_string(state) + " ? ? ? ?)"), 0);
}

TEST_F(Coordinator, MovesNothingForWhatHoldsAlready) {
  want("(goal (on-table circle))");
  ASSERT_TRUE(cell.run_until("(goal-state 1 reached ?)", 20s));
  EXPECT_EQ(cell.motions, 0);
}

TEST_F(Coordinator, RefusesAnObjectThatWasNeverLearned) {
  EXPECT_EQ(cell.request("coordinator", "(goal (on star triangle))")[1], "unknown-object"_sym);
  EXPECT_EQ(cell.request("coordinator", "(goal (above circle triangle))")[1], "unknown-predicate"_sym);
  EXPECT_TRUE(cell.facts("(goal ? ?)").empty());
}

TEST_F(Coordinator, RefusesAMissingObjectAfterLookingForItAndKeepsTheArmStill) {
  cell.hidden.insert("circle");
  want("(goal (on circle triangle))");
  ASSERT_TRUE(cell.run_until("(goal-state 1 refused ?)", 30s));
  EXPECT_EQ(cell.facts("(goal-state 1 refused ?)")[0][3][1], "missing-object"_sym);
  EXPECT_EQ(cell.grip, Eigen::Vector3d(370, 0, 410));
}

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

TEST_F(Coordinator, RefusesWhatThePlannerProvesImpossible) {
  want("(goal (on circle triangle) (on triangle circle))");
  ASSERT_TRUE(cell.run_until("(goal-state 1 refused ?)", 30s));
  EXPECT_EQ(cell.facts("(goal-state 1 refused ?)")[0][3][1], "no-plan"_sym);
  EXPECT_EQ(cell.motions, 0);
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

TEST_F(Coordinator, CutsAMotionShortWithinALookAfterTheOneThatShowsItsTargetElsewhere) {
  cell.motion_takes = 2s;
  want("(goal (holding circle))");
  ASSERT_TRUE(cell.run_until("(servo 2 circle ? ? ?)", 60s));
  cell.run_for(500ms);
  const int motions = cell.motions;
  cell.cubes["circle"].x() += 40;
  EXPECT_TRUE(cell.run_until("(request ? robot (finish stop ?))", 220ms));
  cell.run_for(1800ms);
  EXPECT_EQ(cell.motions, motions) << "the motion goes no further";
  ASSERT_TRUE(cell.run_until("(goal-state 1 reached ?)", 120s));
  EXPECT_EQ(cell.held, "circle");
}

TEST_F(Coordinator, TellsAPersonsStopDuringACutAsAStop) {
  cell.motion_takes = 2s;
  cell.also_stopped_by = list("stop"_sym, "anna"_sym, "wait");
  want("(goal (holding circle))");
  ASSERT_TRUE(cell.run_until("(servo 2 circle ? ? ?)", 60s));
  cell.run_for(500ms);
  cell.cubes["circle"].x() += 40;
  ASSERT_TRUE(cell.run_until("(request ? robot (finish stop ?))", 220ms));
  cell.run_for(500ms);
  EXPECT_EQ(cell.times_told("(event ? servo \"circle was moved: the motion towards it is cut short\" ?)"), 0);
  EXPECT_EQ(cell.times_told("(operation ? ? failed)"), 1);
}

// How long after the motion in hand the servo decides on the next one.
Duration pause_after_motion(FakeCell& cell) {
  const int motions = cell.motions;
  const int decided = cell.times_told("(servo ? circle ? ? ?)");
  const Time late = cell.now() + 5s;
  while (cell.motions == motions && cell.now() < late) cell.run_for(1ms);
  const Time ended = cell.now();
  while (cell.times_told("(servo ? circle ? ? ?)") == decided && cell.now() < late) cell.run_for(1ms);
  return cell.now() - ended;
}

void approach(FakeCell& cell) {
  cell.motion_takes = 330ms;
  cell.request("coordinator", "(goal (holding circle))");
  EXPECT_TRUE(cell.run_until("(servo 2 circle ? ? ?)", 60s));
}

TEST_F(Coordinator, DecidesByTheFirstLookThatShowsTheArmAtRest) {
  approach(cell);
  EXPECT_LE(pause_after_motion(cell), 150ms);
}

TEST_F(Coordinator, TakesTheSecondLookOfEyesThatDoNotSayWhenTheyLooked) {
  cell.tells_capture = false;
  approach(cell);
  EXPECT_GE(pause_after_motion(cell), 100ms);
}

TEST_F(Coordinator, TakesNoLookForNewThatWasCapturedDuringTheMotionAndCameLate) {
  approach(cell);
  cell.run_for(150ms);
  cell.look_late = 500ms;
  EXPECT_GE(pause_after_motion(cell), 450ms);
}

TEST_F(Coordinator, CutsNoMotionShortWhoseTargetRests) {
  cell.motion_takes = 2s;
  want("(goal (on circle square))");
  ASSERT_TRUE(cell.run_until("(goal-state 1 reached ?)", 180s));
  EXPECT_EQ(cell.times_told("(request ? robot (finish stop ?))"), 0);
}

TEST_F(Coordinator, FollowsACubeThatIsMovedDuringTheApproachWithoutANewPlan) {
  want("(goal (on circle triangle))");
  ASSERT_TRUE(cell.run_until("(servo 3 circle ? ? ?)", 30s));
  cell.cubes["circle"].y() -= 45;
  ASSERT_TRUE(cell.run_until("(goal-state 1 reached ?)", 60s));
  expect_on("circle", "triangle");
  EXPECT_EQ(cell.times_told("(plan 1 ?)"), 1);
}

TEST_F(Coordinator, GoesOnByTheArmsOwnWordWhereItsMarkIsHidden) {
  cell.pose_error_mm = {7, -8, 3};
  cell.mark_hidden = [this] { return cell.grip.z() < 110; };
  want("(goal (on circle triangle))");
  ASSERT_TRUE(cell.run_until("(goal-state 1 reached ?)", 60s));
  expect_on("circle", "triangle");
  EXPECT_EQ(cell.times_told("(operation ? ? failed)"), 0);
}

TEST_F(Coordinator, NamesTheMarkThatIsNotSeenAndNotTheObjectThatIs) {
  cell.tells_pose = false;
  cell.mark_hidden = [this] { return cell.grip.z() < 110; };
  want("(goal (on circle triangle))");
  ASSERT_TRUE(cell.run_until("(goal-state 1 refused ?)", 120s));
  const Datum why = cell.facts("(goal-state 1 refused ?)")[0][3];
  EXPECT_EQ(why[1], "lost-sight"_sym) << write(why);
  EXPECT_EQ(why[3], "end-effector"_sym) << write(why);
  EXPECT_NE(why[2].text().find("end-effector"), std::string_view::npos) << write(why);
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

TEST_F(Coordinator, PutsRightWhatOthersTellAndRetractOfWhatItBelieves) {
  want("(goal (on circle triangle))");
  ASSERT_TRUE(cell.run_until("(goal-state 1 reached ?)", 60s));
  cell.forget("(on ? ?)");
  cell.forget("(believed (on-table square))");
  cell.tell("(on square circle)");
  cell.tell("(believed (holding square))");
  cell.run_for(1s);
  EXPECT_EQ(cell.facts("(on ? ?)"), cell.facts("(on circle triangle)"));
  EXPECT_EQ(cell.facts("(on circle triangle)").size(), 1u);
  EXPECT_EQ(cell.facts("(believed (on-table square))").size(), 1u);
  EXPECT_TRUE(cell.facts("(believed (holding ?))").empty());
}

TEST_F(Coordinator, PutsRightWhatOthersToldBeforeItHasLookedAndWithoutEnd) {
  for (int i = 0; i < 50; ++i) {
    cell.tell("(on square circle)");
    cell.run_for(10ms);
  }
  cell.run_for(1s);
  EXPECT_TRUE(cell.facts("(on ? ?)").empty());
  EXPECT_LE(cell.times_told("(on square circle)"), 7) << "put right more often than ten times a second";
}

TEST_F(Coordinator, SkipsAStepThatSomebodyElseDid) {
  want("(goal (on triangle square) (on circle triangle))");
  ASSERT_TRUE(cell.run_until("(operation 1 ? done)", 60s));
  cell.cubes["circle"] = cell.cubes["triangle"] + Eigen::Vector3d(0, 0, 60);
  ASSERT_TRUE(cell.run_until("(goal-state 1 reached ?)", 60s));
  EXPECT_EQ(cell.times_told("(operation ? (STACK circle triangle) ?)"), 0);
  EXPECT_FALSE(cell.facts("(event ? difference ? ?)").empty());
}

TEST_F(Coordinator, FetchesAgainWhatWasTakenOutOfTheGripper) {
  want("(goal (on circle triangle))");
  ASSERT_TRUE(cell.run_until("(operation ? (STACK circle triangle) running)", 60s));
  cell.held.clear();
  cell.opening_mm = 0;
  cell.cubes["circle"] = {450, -180, 30};
  ASSERT_TRUE(cell.run_until("(goal-state 1 reached ?)", 90s));
  expect_on("circle", "triangle");
  EXPECT_FALSE(cell.facts("(event ? difference ? ?)").empty());
}

TEST_F(Coordinator, NoticesAtOnceThatTheRaisedArmLeftACubeWhereItLay) {
  want("(goal (on circle triangle))");
  ASSERT_TRUE(cell.run_until("(gripper robot 60.0)", 60s));
  cell.held.clear();
  ASSERT_TRUE(cell.run_until("(micro-task ? (check-held circle) running)", 30s));
  EXPECT_TRUE(cell.run_until("(micro-task ? (check-held circle) failed)", 500ms));
  ASSERT_TRUE(cell.run_until("(goal-state 1 reached ?)", 90s));
}

// It slides off what it is put on, and is picked up again each time.
TEST_F(Coordinator, TriesAnOperationAgainAsLongAsOthersSucceedBetween) {
  int falls = 0;
  cell.covered = [&](const std::string& name) {
    Eigen::Vector3d& circle = cell.cubes["circle"];
    const bool is_stacked = name == "circle" && cell.held.empty() && circle.z() > 60;
    if (is_stacked && falls < 8) {
      ++falls;
      circle = {450, -150, 30};
    }
    return false;
  };
  want("(goal (on circle triangle))");
  ASSERT_TRUE(cell.run_until("(goal-state 1 reached ?)", 300s)) << write(Datum::list(cell.facts("(goal-state ? ? ?)")));
  EXPECT_EQ(cell.times_told("(operation ? (STACK circle triangle) failed)"), 8);
}

TEST_F(Coordinator, BuildsAgainWhatIsKnockedOverBeforeItHasSettled) {
  want("(goal (on circle triangle))");
  ASSERT_TRUE(cell.run_until("(on circle triangle)", 60s));
  cell.cubes["circle"] = {450, -200, 30};
  ASSERT_TRUE(cell.run_until("(goal-state 1 reached ?)", 90s));
  expect_on("circle", "triangle");
}

TEST_F(Coordinator, CallsNoGoalReachedWhileNobodySeesWhetherItHolds) {
  cell.cubes["circle"] = {455, -50, 90};
  cell.run_for(3s);
  want("(goal (on circle triangle))");
  ASSERT_TRUE(cell.run_until("(event ? plan ? ?)", 20s));
  cell.stop_vision();
  cell.cubes["circle"] = {450, -150, 30};
  cell.run_for(3s);
  cell.start_vision();
  ASSERT_TRUE(cell.run_until("(goal-state 1 reached ?)", 120s));
  expect_on("circle", "triangle");
}

TEST_F(Coordinator, CallsNoGoalReachedByLooksFromBeforeAPause) {
  cell.cubes["circle"] = {455, -50, 90};
  cell.run_for(3s);
  want("(goal (on circle triangle))");
  ASSERT_TRUE(cell.run_until("(event ? plan ? ?)", 20s));
  cell.run_for(1s);
  cell.look_late = 3s;
  cell.run_for(150ms);
  cell.cubes["circle"] = {450, -150, 30};
  ASSERT_TRUE(cell.run_until("(goal-state 1 reached ?)", 120s));
  expect_on("circle", "triangle");
}

TEST_F(Coordinator, TellsWhyWithTheFrameThatShowedTheDifference) {
  want("(goal (on circle triangle))");
  ASSERT_TRUE(cell.run_until("(operation ? (PICK-UP circle) running)", 30s));
  cell.cubes["square"] = cell.cubes["circle"] + Eigen::Vector3d(0, 0, 60);
  ASSERT_TRUE(cell.run_until("(event ? difference ? ?)", 30s));
  const std::string why = want("(why)");
  EXPECT_NE(why.find("(clear circle) does not hold since frame "), std::string::npos) << why;
  EXPECT_NE(why.find("(on square circle)"), std::string::npos) << why;
  ASSERT_TRUE(cell.run_until("(goal-state 1 reached ?)", 120s));
  expect_on("circle", "triangle");
}

TEST_F(Coordinator, GoesOnAfterItWasKilledWhileHolding) {
  want("(goal (on circle triangle))");
  ASSERT_TRUE(cell.run_until("(and (holding circle) (operation ? (STACK circle triangle) running))", 60s));
  cell.stop_coordinator();
  cell.run_for(5s);
  EXPECT_TRUE(cell.facts("(holding circle)").empty()) << "what it believed goes with it";
  cell.start_coordinator();
  ASSERT_TRUE(cell.run_until("(goal-state 1 reached ?)", 60s));
  expect_on("circle", "triangle");
  EXPECT_EQ(cell.times_told("(plan 1 ?)"), 1) << "the plan it had still serves";
}

TEST_F(Coordinator, GoesOnWithTheSamePlanAfterThePlannerWasKilled) {
  want("(goal (on triangle square) (on circle triangle))");
  ASSERT_TRUE(cell.run_until("(and (holding triangle) (operation ? (STACK triangle square) running))", 60s));
  cell.stop_planner();
  cell.run_for(5s);
  cell.start_planner();
  ASSERT_TRUE(cell.run_until("(goal-state 1 reached ?)", 120s));
  expect_on("circle", "triangle");
  EXPECT_EQ(cell.times_told("(plan 1 ?)"), 1) << "the plan it had still serves";
  EXPECT_TRUE(cell.facts("(event ? difference ? ?)").empty());
}

TEST_F(Coordinator, RefusesWhenThePlannerStaysAway) {
  want("(goal (on triangle square) (on circle triangle))");
  ASSERT_TRUE(cell.run_until("(holding triangle)", 60s));
  cell.stop_planner();
  ASSERT_TRUE(cell.run_until("(goal-state 1 refused ?)", 90s));
  EXPECT_EQ(cell.facts("(goal-state 1 refused ?)")[0][3][1], "absent"_sym);
}

// Step b of the thesis.
TEST_F(Coordinator, FindsEachObjectOfTheGoalBeforeItPlansWhateverWasSeenLately) {
  want("(goal (on-table circle))");
  ASSERT_TRUE(cell.run_until("(goal-state 1 reached ?)", 30s));
  want("(goal (on circle triangle))");
  ASSERT_TRUE(cell.run_until("(plan 2 ?)", 30s));
  EXPECT_GE(cell.times_told("(request ? vision (find \"circle\"))"), 2);
  EXPECT_GE(cell.times_told("(request ? vision (find \"triangle\"))"), 1);
  EXPECT_EQ(cell.times_told("(request ? vision (find \"square\"))"), 0);
}

// The planner hands out what follows from what is seen, and one request makes a plan.
TEST_F(Coordinator, AsksForEachThingOnce) {
  want("(goal (on circle triangle) (on triangle square))");
  ASSERT_TRUE(cell.run_until("(goal-state 1 reached ?)", 120s));
  EXPECT_EQ(cell.times_told("(request ? vision (get-objects))"), 1);
  EXPECT_EQ(cell.times_told("(request ? planner (make-plan ? ? ? ? ?))"), 1);
  EXPECT_EQ(cell.times_told("(request ? planner (next-operation ? ?))"), 5) << "four operations, and that it is done";
  EXPECT_EQ(cell.times_told("(request ? planner ?)"), 6);
}

TEST_F(Coordinator, WaitsForARobotThatDied) {
  want("(goal (on circle triangle))");
  ASSERT_TRUE(cell.run_until("(holding circle)", 60s));
  cell.stop_robot();
  cell.run_for(5s);
  cell.start_robot();
  ASSERT_TRUE(cell.run_until("(goal-state 1 reached ?)", 90s));
  expect_on("circle", "triangle");
}

TEST_F(Coordinator, RefusesWhenTheRobotStaysAway) {
  cell.stop_robot();
  cell.run_for(3s);
  want("(goal (on circle triangle))");
  ASSERT_TRUE(cell.run_until("(goal-state 1 refused ?)", 60s));
  EXPECT_EQ(cell.facts("(goal-state 1 refused ?)")[0][3][1], "absent"_sym);
}

TEST_F(Coordinator, HasARestartedVisionTrackAgain) {
  want("(goal (on circle triangle))");
  ASSERT_TRUE(cell.run_until("(servo 2 ? ? ? ?)", 30s));
  cell.stop_vision();
  cell.run_for(4s);
  cell.start_vision();
  ASSERT_TRUE(cell.run_until("(goal-state 1 reached ?)", 90s));
  expect_on("circle", "triangle");
}

TEST_F(Coordinator, HasEyesThatRestartedTrackAllWhereTheyTrackAPart) {
  want("(goal (on circle triangle))");
  ASSERT_TRUE(cell.run_until("(operation ? ? running)", 30s));
  cell.stop_coordinator();
  cell.stop_vision();
  cell.run_for(4s);
  cell.start_vision();
  cell.request("vision", "(track \"end-effector\")");
  cell.request("vision", "(track \"circle\")");
  cell.start_coordinator();
  ASSERT_TRUE(cell.run_until("(goal-state 1 reached ?)", 90s));
  expect_on("circle", "triangle");
}

TEST_F(Coordinator, TracksAgainWhatTheEyesForgotInTheMiddleOfTheAsking) {
  cell.eyes_restart_at = "square";
  want("(goal (on circle triangle))");
  ASSERT_TRUE(cell.run_until("(goal-state 1 reached ?)", 90s));
  expect_on("circle", "triangle");
}

TEST_F(Coordinator, AsksTheEyesOnlyOnceToTrackWhatTheyTrack) {
  want("(goal (on-table circle))");
  ASSERT_TRUE(cell.run_until("(goal-state 1 reached ?)", 20s));
  EXPECT_EQ(cell.times_told("(request ? vision (track ?))"), 4);
  want("(goal (on-table square))");
  ASSERT_TRUE(cell.run_until("(goal-state 2 reached ?)", 20s));
  EXPECT_EQ(cell.times_told("(request ? vision (track ?))"), 4);
}

TEST_F(Coordinator, ReplacesAGoalAndPutsAwayWhatItHoldsThroughTheNewPlan) {
  want("(goal (on circle triangle))");
  ASSERT_TRUE(cell.run_until("(holding circle)", 60s));
  EXPECT_EQ(want("(goal (on square triangle))"), "(ok 2)");
  ASSERT_TRUE(cell.run_until("(goal-state 2 reached ?)", 90s));
  EXPECT_EQ(cell.facts("(goal-state 1 replaced ?)").size(), 1U);
  expect_on("square", "triangle");
  EXPECT_TRUE(cell.held.empty());
}

TEST_F(Coordinator, EndsWhenCancelled) {
  EXPECT_EQ(cell.request("coordinator", "(cancel)")[1], "no-goal"_sym);
  want("(goal (on circle triangle))");
  ASSERT_TRUE(cell.run_until("(operation ? (PICK-UP circle) running)", 30s));
  EXPECT_EQ(want("(cancel)"), "(ok)");
  EXPECT_EQ(cell.facts("(goal-state 1 cancelled ?)").size(), 1U);
  cell.run_for(2s);
  const int motions = cell.motions;
  cell.run_for(10s);
  EXPECT_EQ(cell.motions, motions);
}

TEST_F(Coordinator, StaysWithTheGoalInHandWhenAnotherCannotBeKept) {
  want("(goal (on circle triangle))");
  ASSERT_TRUE(cell.run_until("(holding circle)", 60s));
  cell.disk = Disk::full;
  EXPECT_EQ(cell.request("coordinator", "(goal (on square triangle))")[1], "journal-full"_sym);
  EXPECT_EQ(cell.request("coordinator", "(cancel)")[1], "journal-full"_sym);
  cell.disk = Disk::sound;
  ASSERT_TRUE(cell.run_until("(goal-state 1 reached ?)", 60s));
  expect_on("circle", "triangle");
  EXPECT_EQ(cell.times_told("(operation ? (PICK-UP square) ?)"), 0);
  EXPECT_EQ(want("(goal (on square circle))"), "(ok 2)") << "a refused goal has no number";
}

TEST_F(Coordinator, MovesNothingForAGoalThatCannotBeKept) {
  cell.disk = Disk::full;
  EXPECT_EQ(cell.request("coordinator", "(goal (on circle triangle))")[1], "journal-full"_sym);
  EXPECT_EQ(cell.request("coordinator", "(cancel)")[1], "no-goal"_sym);
  cell.run_for(10s);
  EXPECT_EQ(cell.motions, 0);
  EXPECT_TRUE(cell.facts("(goal ? ?)").empty());
}

TEST_F(Coordinator, TellsThatAGoalIsReachedOnceThatCanBeKept) {
  want("(goal (on circle triangle))");
  ASSERT_TRUE(cell.run_until("(on circle triangle)", 60s));
  cell.disk = Disk::full;
  cell.run_for(20s);
  EXPECT_TRUE(cell.facts("(goal-state 1 reached ?)").empty());
  EXPECT_EQ(cell.request("coordinator", "(cancel)")[1], "journal-full"_sym) << "it listens meanwhile";
  cell.disk = Disk::sound;
  EXPECT_TRUE(cell.run_until("(goal-state 1 reached ?)", 5s));
}

TEST_F(Coordinator, GoesOnWithItsGoalAfterTheDiskWasFullInTheMiddleOfAnOperation) {
  want("(goal (on circle triangle) (on triangle square))");
  ASSERT_TRUE(cell.run_until("(and (holding triangle) (operation ? (STACK triangle square) running))", 60s));
  cell.disk = Disk::full;
  cell.run_for(60s);
  EXPECT_TRUE(cell.facts("(goal-state 1 refused ?)").empty());
  cell.disk = Disk::sound;
  ASSERT_TRUE(cell.run_until("(goal-state 1 reached ?)", 120s));
  expect_on("circle", "triangle");
  expect_on("triangle", "square");
}

TEST_F(Coordinator, PursuesWhatStandsThoughItMayNotLast) {
  cell.disk = Disk::failing;
  EXPECT_EQ(want("(goal (on circle triangle))"), "(ok 1)");
  ASSERT_TRUE(cell.run_until("(goal-state 1 reached ?)", 60s));
  expect_on("circle", "triangle");
  EXPECT_EQ(want("(goal (on square circle))"), "(ok 2)");
  EXPECT_EQ(want("(cancel)"), "(ok)");
  EXPECT_EQ(cell.facts("(goal-state 2 cancelled ?)").size(), 1U);
}

TEST_F(Coordinator, TellsWhyAfterTheBoardWasKilledWhileTheCellWasIdle) {
  want("(goal (on circle triangle))");
  ASSERT_TRUE(cell.run_until("(goal-state 1 reached ?)", 60s));
  cell.run_for(1s);
  const std::string before = want("(why)");
  EXPECT_NE(before.find("goal 1 is reached"), std::string::npos) << before;
  cell.restart_board();
  EXPECT_EQ(want("(why)"), before);
  want("(goal (on circle triangle) (on triangle circle))");
  ASSERT_TRUE(cell.run_until("(goal-state 2 refused ?)", 30s));
  cell.run_for(1s);
  const std::string refused = want("(why)");
  EXPECT_NE(refused.find("goal 2 is refused"), std::string::npos) << refused;
  cell.restart_board();
  EXPECT_EQ(want("(why)"), refused);
}

TEST_F(Coordinator, TellsWhyOfAGoalWhoseBeginningTheStoryHasForgotten) {
  want("(goal (on circle triangle))");
  ASSERT_TRUE(cell.run_until("(goal-state 1 reached ?)", 60s));
  cell.run_for(1s);
  cell.forget("(event ? ? ? ?)");
  const std::string why = want("(why)");
  EXPECT_NE(why.find("goal 1: (on circle triangle)"), std::string::npos) << why;
  EXPECT_NE(why.find("goal 1 is reached"), std::string::npos) << why;
}

TEST_F(Coordinator, TellsThatThePlanInHandStillServes) {
  want("(goal (on triangle square) (on circle triangle))");
  ASSERT_TRUE(cell.run_until("(operation 2 (PICK-UP circle) running)", 60s));
  ASSERT_TRUE(cell.run_until("(servo 2 ? ? ? ?)", 30s));
  cell.cubes["triangle"] = {450, -200, 30};
  ASSERT_TRUE(cell.run_until("(goal-state 1 reached ?)", 120s));
  EXPECT_EQ(cell.times_told("(plan 1 ?)"), 1) << "no new plan was made";
  const std::string kept =
      "the plan in hand still serves, from operation 1 on: (PICK-UP triangle) (STACK triangle square) "
      "(PICK-UP circle) (STACK circle triangle)";
  bool told = false;
  for (const Datum& event : cell.facts("(event ?n plan ?sentence ?detail)")) told = told || event[3].text() == kept;
  EXPECT_TRUE(told);
  const std::string why = want("(why)");
  EXPECT_NE(why.find(kept), std::string::npos) << why;
}

TEST_F(Coordinator, PutsDownWhereThereIsRoom) {
  want("(goal (on circle triangle))");
  ASSERT_TRUE(cell.run_until("(goal-state 1 reached ?)", 60s));
  want("(goal (on-table circle))");
  ASSERT_TRUE(cell.run_until("(goal-state 2 reached ?)", 60s));
  EXPECT_NEAR(cell.cubes["circle"].z(), 30, 1);
  for (const auto& [name, place] : cell.cubes) {
    if (name == "circle") continue;
    EXPECT_GT(std::abs(place.y() - cell.cubes["circle"].y()), 85) << name;
  }
}

}  // namespace
}  // namespace pizarra::coordinator
