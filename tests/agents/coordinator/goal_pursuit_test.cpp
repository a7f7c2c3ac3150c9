#include "tests/agents/coordinator/coordinator_fixture.hpp"

namespace pizarra::coordinator {
namespace {

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

TEST_F(Coordinator, GoesOutwardsWhereTheArmComesNeitherUpNorInwards) {
  cell.nearest_mm = 475;
  want("(goal (on circle triangle))");
  ASSERT_TRUE(cell.run_until("(goal-state 1 reached ?)", 120s));
  expect_on("circle", "triangle");
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

TEST_F(Coordinator, RefusesWhatThePlannerProvesImpossible) {
  want("(goal (on circle triangle) (on triangle circle))");
  ASSERT_TRUE(cell.run_until("(goal-state 1 refused ?)", 30s));
  EXPECT_EQ(cell.facts("(goal-state 1 refused ?)")[0][3][1], "no-plan"_sym);
  EXPECT_EQ(cell.motions, 0);
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

// A cube that stands askew slips for seconds before it falls.
TEST_F(Coordinator, CallsNoGoalReachedWhoseObjectsStillMove) {
  cell.cubes["triangle"] = {500, 50, 30};
  cell.cubes["circle"] = {500, 50, 90};
  cell.run_for(3s);
  want("(goal (on circle triangle))");
  ASSERT_TRUE(cell.run_until("(event ? plan ? ?)", 20s));
  for (int step = 0; step < 30; ++step) {
    cell.cubes["circle"].x() -= 0.8;
    cell.run_for(100ms);
    ASSERT_TRUE(cell.facts("(goal-state 1 reached ?)").empty()) << "step " << step;
  }
  cell.cubes["circle"] = {440, 50, 30};
  ASSERT_TRUE(cell.run_until("(goal-state 1 reached ?)", 120s));
  expect_on("circle", "triangle");
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

TEST_F(Coordinator, TellsWhyOfAGoalWhoseBeginningTheStoryHasForgotten) {
  want("(goal (on circle triangle))");
  ASSERT_TRUE(cell.run_until("(goal-state 1 reached ?)", 60s));
  cell.run_for(1s);
  cell.forget("(event ? ? ? ?)");
  const std::string why = want("(why)");
  EXPECT_NE(why.find("goal 1: (on circle triangle)"), std::string::npos) << why;
  EXPECT_NE(why.find("goal 1 is reached"), std::string::npos) << why;
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
