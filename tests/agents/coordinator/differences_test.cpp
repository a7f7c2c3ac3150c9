#include "tests/agents/coordinator/coordinator_fixture.hpp"

namespace pizarra::coordinator {
namespace {

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

}  // namespace
}  // namespace pizarra::coordinator
