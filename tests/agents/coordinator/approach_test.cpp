#include "tests/agents/coordinator/coordinator_fixture.hpp"

namespace pizarra::coordinator {
namespace {

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

}  // namespace
}  // namespace pizarra::coordinator
