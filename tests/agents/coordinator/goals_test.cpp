#include <gtest/gtest.h>

#include "lisp/writer.hpp"
#include "tests/agents/coordinator/fake_cell.hpp"

namespace pizarra::coordinator {
namespace {

FakeCell::Cubes three_in_a_row() {
  return {{"circle", {450, -150, 30}}, {"triangle", {455, -50, 30}}, {"square", {445, 50, 30}}};
}

class Goals : public testing::Test {
 protected:
  Goals() { cell.start_coordinator(); }
  std::string want(std::string_view goal) { return write(cell.request("coordinator", goal)); }
  bool stands_on(const std::string& upper, const std::string& lower) {
    const Eigen::Vector3d apart = cell.cubes[upper] - cell.cubes[lower];
    return std::hypot(apart.x(), apart.y()) < 4 && std::abs(apart.z() - 60) < 1;
  }

  FakeCell cell{"blocks.scm", three_in_a_row()};
};

TEST_F(Goals, EitherIsHadTheShorterWay) {
  EXPECT_EQ(want("(goal (or (and (on circle triangle) (on triangle square)) (on square circle)))"), "(ok 1)");
  ASSERT_TRUE(cell.run_until("(goal-state 1 reached ?)", 120s));
  EXPECT_TRUE(stands_on("square", "circle"));
  EXPECT_EQ(cell.facts("(plan 1 ?)")[0][2].size(), 2U);
}

TEST_F(Goals, WhatShallNotBeIsUndone) {
  cell.cubes["circle"] = {455, -50, 90};
  want("(goal (not (on circle triangle)))");
  ASSERT_TRUE(cell.run_until("(goal-state 1 reached ?)", 60s));
  EXPECT_FALSE(stands_on("circle", "triangle"));
}

TEST_F(Goals, AQuantifierIsAboutWhatIsSeen) {
  cell.cubes["circle"] = {455, -50, 90};
  cell.cubes["square"] = {455, -50, 150};
  want("(goal (forall (<x> OBJECT) (on-table <x>)))");
  ASSERT_TRUE(cell.run_until("(goal-state 1 reached ?)", 120s));
  for (const auto& [name, centre] : cell.cubes) EXPECT_NEAR(centre.z(), 30, 1) << name;
}

TEST_F(Goals, AllOfATypeAreLookedForThatWereSeenBeforeAndAreNotSeenNow) {
  cell.cubes["circle"] = {445, 50, 90};
  want("(goal (on circle square))");
  ASSERT_TRUE(cell.run_until("(goal-state 1 reached ?)", 60s));
  cell.cubes["triangle"] = {505, 50, 30};
  cell.covered = [this](const std::string& name) {
    const Eigen::Vector3d& before = cell.cubes["triangle"];
    return name == "circle" && before.x() > 480 && std::abs(before.y() - 50) < 70 && before.z() < 60;
  };
  cell.run_for(3s);
  want("(goal (forall (<x> OBJECT) (on-table <x>)))");
  ASSERT_TRUE(cell.run_until("(goal-state 2 reached ?)", 120s));
  EXPECT_EQ(cell.times_told("(event ? servo \"setting triangle aside, to see what it hides\" ?)"), 1);
  EXPECT_NEAR(cell.cubes["circle"].z(), 30, 1) << "reached is said of all that is there";
}

TEST_F(Goals, WhatIsLookedForInVainCountsAsAwayUntilItIsSeenAgain) {
  want("(goal (on circle square))");
  ASSERT_TRUE(cell.run_until("(goal-state 1 reached ?)", 60s));
  cell.hidden = {"circle"};
  cell.run_for(3s);
  want("(goal (forall (<x> OBJECT) (on-table <x>)))");
  ASSERT_TRUE(cell.run_until("(goal-state 2 reached ?)", 200s));
  const std::string_view away =
      "(event ? missing \"circle is not seen and counts as away: the goal is about what is "
      "there\" circle)";
  EXPECT_EQ(cell.times_told(away), 1);
  // Somebody brings it back.
  cell.cubes["circle"] = cell.cubes["triangle"] + Eigen::Vector3d(0, 0, 60);
  cell.hidden.clear();
  want("(goal (forall (<x> OBJECT) (on-table <x>)))");
  ASSERT_TRUE(cell.run_until("(goal-state 3 reached ?)", 120s));
  for (const auto& [name, centre] : cell.cubes) EXPECT_NEAR(centre.z(), 30, 1) << name;
  EXPECT_EQ(cell.times_told(away), 1);
}

TEST_F(Goals, AQuantifierIsAboutWhatCameAfterThePlanWasMadeToo) {
  cell.cubes["square"] = {455, -50, 90};
  cell.hidden = {"circle"};
  want("(goal (forall (<x> OBJECT) (on-table <x>)))");
  ASSERT_TRUE(cell.run_until("(operation 1 (PUT-DOWN square) running)", 60s));
  cell.cubes["circle"] = {455, -50, 90};
  cell.hidden.clear();
  ASSERT_TRUE(cell.run_until("(goal-state 1 reached ?)", 60s));
  for (const auto& [name, centre] : cell.cubes) EXPECT_NEAR(centre.z(), 30, 1) << name;
}

TEST_F(Goals, WhatWasNeverSeenIsNotLookedForByAQuantifier) {
  cell.hidden = {"circle"};
  want("(goal (forall (<x> OBJECT) (on-table <x>)))");
  ASSERT_TRUE(cell.run_until("(goal-state 1 reached ?)", 10s));
  EXPECT_EQ(cell.times_told("(event ? missing ? ?)"), 0);
}

TEST_F(Goals, SomeOfATypeAreLookedForOnlyWhereThoseThatAreSeenDoNotDo) {
  want("(goal (on-table circle))");
  ASSERT_TRUE(cell.run_until("(goal-state 1 reached ?)", 60s));
  cell.cubes["triangle"] = {505, -150, 30};
  cell.covered = [this](const std::string& name) {
    const Eigen::Vector3d& before = cell.cubes["triangle"];
    return name == "circle" && before.x() > 480 && std::abs(before.y() + 150) < 70 && before.z() < 60;
  };
  cell.run_for(3s);
  const std::string_view aside = "(event ? servo \"setting triangle aside, to see what it hides\" ?)";
  want("(goal (at-least 2 (<x> OBJECT) (on-table <x>)))");
  ASSERT_TRUE(cell.run_until("(goal-state 2 reached ?)", 30s));
  EXPECT_EQ(cell.times_told(aside), 0);
  want("(goal (at-least 3 (<x> OBJECT) (on-table <x>)))");
  ASSERT_TRUE(cell.run_until("(goal-state 3 reached ?)", 120s));
  EXPECT_EQ(cell.times_told(aside), 1);
}

TEST_F(Goals, ANumberOfThemIsEnough) {
  want("(goal (at-least 1 (<x> OBJECT) (on <x> circle)) (at-least 2 (<x> OBJECT) (on-table <x>)))");
  ASSERT_TRUE(cell.run_until("(goal-state 1 reached ?)", 60s));
  EXPECT_TRUE(stands_on("square", "circle") || stands_on("triangle", "circle"));
}

TEST_F(Goals, NoPlanIsProvedOfEveryWay) {
  want("(goal (or (on circle circle) (and (on circle square) (on square circle))))");
  ASSERT_TRUE(cell.run_until("(goal-state 1 refused ?)", 60s));
  EXPECT_EQ(cell.facts("(goal-state 1 refused ?)")[0][3][1], "no-plan"_sym);
}

TEST_F(Goals, WhyNotNamesWhatDoesNotHoldAndThePlanThatWouldBringItAbout) {
  cell.cubes["square"] = {450, -150, 90};
  EXPECT_EQ(want("(why-not (on circle triangle) (on-table triangle))"),
            "(ok \"(on circle triangle) does not hold; what is seen: (bare triangle) (clear triangle) "
            "(on square circle) (on-table circle) (on-table triangle)\" "
            "\"a plan leads there: (UNSTACK square circle) (PUT-DOWN square) (PICK-UP circle) "
            "(STACK circle triangle)\")");
  EXPECT_EQ(want("(why-not (on square circle))"), "(ok \"(on square circle) holds\")");
  EXPECT_TRUE(cell.facts("(goal ? ?)").empty());
}

TEST_F(Goals, WhyNotSaysWhoIsMissingAndThatThereIsNoPlan) {
  cell.hidden = {"circle", "square"};
  EXPECT_TRUE(want("(why-not (on circle square))").ends_with("\"circle and square are not seen\")"));
  cell.hidden.clear();
  const std::string none = want("(why-not (on circle square) (on square circle))");
  EXPECT_NE(none.find("(on square circle) does not hold"), std::string::npos) << none;
  EXPECT_NE(none.find("no plan"), std::string::npos) << none;
}

TEST_F(Goals, WhyNotOfWhatCanBeHadInSeveralWaysNamesWhatTheNearestLacks) {
  cell.cubes["square"] = {450, -150, 90};
  const std::string said =
      want("(why-not (then (forall (<x> OBJECT) (on-table <x>)) (exists (<x> OBJECT) (on <x> square))))");
  EXPECT_NE(said.find("stage 1: (forall (<x> OBJECT) (on-table <x>)) does not hold: the nearest way to it lacks "
                      "(on-table square); "),
            std::string::npos)
      << said;
  EXPECT_NE(said.find("stage 2: a plan leads there: "), std::string::npos) << said;
  EXPECT_EQ(want("(why-not (on circle star))").substr(0, 6), "(fail ");
}

TEST_F(Goals, WhyNotLeavesThePlanInUseAlone) {
  want("(goal (on circle triangle))");
  ASSERT_TRUE(cell.run_until("(operation 0 ? running)", 30s));
  EXPECT_TRUE(want("(why-not (on square circle))").starts_with("(ok "));
  ASSERT_TRUE(cell.run_until("(goal-state 1 reached ?)", 60s));
  EXPECT_EQ(cell.times_told("(request ? planner (make-plan ? ? ? ? ?))"), 1);
}

TEST_F(Goals, StagesAreReachedOneAfterAnother) {
  want("(goal (then (on circle triangle) (on triangle circle)))");
  ASSERT_TRUE(cell.run_until("(goal-state 1 running (stage 2))", 60s));
  EXPECT_TRUE(stands_on("circle", "triangle"));
  ASSERT_TRUE(cell.run_until("(goal-state 1 reached ?)", 90s));
  EXPECT_TRUE(stands_on("triangle", "circle"));
}

TEST_F(Goals, AStageThatWasReachedIsNotPursuedAgainByANewLife) {
  want("(goal (then (on circle triangle) (on triangle circle)))");
  ASSERT_TRUE(cell.run_until("(goal-state 1 running (stage 2))", 60s));
  cell.stop_coordinator();
  cell.run_for(3s);
  cell.start_coordinator();
  ASSERT_TRUE(cell.run_until("(goal-state 1 reached ?)", 120s));
  EXPECT_TRUE(stands_on("triangle", "circle"));
}

TEST_F(Goals, WhatIsKeptIsBuiltAgainAnHourLater) {
  want("(goal (keep (on circle triangle)))");
  ASSERT_TRUE(cell.run_until("(goal-state 1 kept ?)", 60s));
  cell.run_for(3600s);
  EXPECT_EQ(cell.facts("(goal-state 1 kept ?)").size(), 1U);
  cell.cubes["circle"] = {450, -170, 30};
  ASSERT_TRUE(cell.run_until("(goal-state 1 running ?)", 10s));
  ASSERT_TRUE(cell.run_until("(goal-state 1 kept ?)", 60s));
  EXPECT_TRUE(stands_on("circle", "triangle"));
  EXPECT_EQ(want("(cancel)"), "(ok)");
}

TEST_F(Goals, WhatIsKeptOutlivesTheCoordinator) {
  want("(goal (keep (on circle triangle)))");
  ASSERT_TRUE(cell.run_until("(goal-state 1 kept ?)", 60s));
  cell.stop_coordinator();
  cell.cubes["circle"] = {450, -170, 30};
  cell.run_for(5s);
  cell.start_coordinator();
  ASSERT_TRUE(cell.run_until("(on circle triangle)", 90s));
  EXPECT_TRUE(stands_on("circle", "triangle"));
}

TEST_F(Goals, AMissingObjectIsWaitedForAndAllThatAreMissingAreNamed) {
  cell.hidden = {"circle", "square"};
  want("(goal (on circle square) (wait 120))");
  ASSERT_TRUE(cell.run_until("(goal-state 1 running (missing circle square))", 60s));
  cell.run_for(20s);
  cell.hidden.clear();
  ASSERT_TRUE(cell.run_until("(goal-state 1 reached ?)", 90s));
  EXPECT_TRUE(stands_on("circle", "square"));
}

TEST_F(Goals, WaitingHasAnEnd) {
  cell.hidden = {"circle"};
  want("(goal (on circle square) (wait 10))");
  ASSERT_TRUE(cell.run_until("(goal-state 1 refused ?)", 60s));
  EXPECT_EQ(cell.facts("(goal-state 1 refused ?)")[0][3][1], "missing-object"_sym);
}

}  // namespace
}  // namespace pizarra::coordinator
