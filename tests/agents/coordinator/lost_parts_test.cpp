#include "tests/agents/coordinator/coordinator_fixture.hpp"

namespace pizarra::coordinator {
namespace {

// The line may fall silent in the middle of every motion for a while, as under load.
TEST_F(Coordinator, IsHeldUpByABoardThatFallsSilentHoweverOften) {
  cell.refusal = "stopped";
  cell.refused_about = list("silent"_sym, "board"_sym);
  want("(goal (on circle triangle))");
  ASSERT_TRUE(cell.run_until("(operation ? (PICK-UP circle) running)", 30s));
  cell.run_for(60s);
  EXPECT_GT(cell.times_told("(operation ? (PICK-UP circle) failed)"), 6);
  EXPECT_TRUE(cell.facts("(goal-state 1 refused ?)").empty());
  cell.refusal.clear();
  ASSERT_TRUE(cell.run_until("(goal-state 1 reached ?)", 90s));
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

}  // namespace
}  // namespace pizarra::coordinator
