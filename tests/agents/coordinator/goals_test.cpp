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
  EXPECT_NE(said.find("stage 2, after stage 1: a plan leads there: "), std::string::npos) << said;
  EXPECT_EQ(want("(why-not (on circle star))").substr(0, 6), "(fail ");
}

TEST_F(Goals, WhyNotPlansEachStageFromTheEndOfTheOneBefore) {
  EXPECT_EQ(want("(why-not (then (on circle triangle) (on triangle circle) (clear triangle)))"),
            "(ok \"stage 1: (on circle triangle) does not hold; what is seen: (bare circle) (bare triangle) "
            "(clear circle) (clear triangle) (on-table circle) (on-table triangle)\" "
            "\"stage 1: a plan leads there: (PICK-UP circle) (STACK circle triangle)\" "
            "\"stage 2, after stage 1: (on triangle circle) does not hold; what holds then: (bare circle) "
            "(clear circle) (on circle triangle) (on-table triangle)\" "
            "\"stage 2, after stage 1: a plan leads there: (UNSTACK circle triangle) (PUT-DOWN circle) "
            "(PICK-UP triangle) (STACK triangle circle)\" "
            "\"stage 3, after stage 2: (clear triangle) holds\")");
}

TEST_F(Goals, WhyNotOfAStageAfterOneWithoutAPlanSaysThatItIsPlannedFromNow) {
  const std::string said = want("(why-not (then (on circle circle) (on triangle circle)))");
  EXPECT_NE(said.find("stage 1: no plan exists: (on circle circle) can never hold"), std::string::npos) << said;
  EXPECT_NE(said.find("stage 2, from what is seen now: a plan leads there: (PICK-UP triangle)"), std::string::npos)
      << said;
  EXPECT_TRUE(
      want("(why-not (then (on-table circle) (on circle square)))")
          .starts_with(
              "(ok \"stage 1: (on-table circle) holds\" \"stage 2: (on circle square) does not hold; what is seen: "));
}

TEST_F(Goals, WhyNotOfAQuantifierNamesWaysThatCanBeHad) {
  const std::string some = want("(why-not (exists (<x> OBJECT) (on circle <x>)))");
  EXPECT_NE(some.find("the nearest way to it lacks (on circle square); "), std::string::npos) << some;
  EXPECT_NE(some.find("(STACK circle square)"), std::string::npos) << some;
  const std::string both = want("(why-not (at-least 2 (<x> OBJECT) (on circle <x>)))");
  EXPECT_NE(both.find("the nearest way to it lacks (on circle square) and (on circle triangle); "), std::string::npos)
      << both;
  EXPECT_NE(both.find("\"none of 3 ways has a plan; of one, (on circle square) and (on circle triangle) can never hold "
                      "together from here\""),
            std::string::npos)
      << both;
}

TEST_F(Goals, MoreObjectsThanThereAreAreRefusedByTheirNumber) {
  const std::string why = "no-plan \"the goal wants 9 of the type OBJECT, and there are only 3\"";
  want("(goal (at-least 9 (<x> OBJECT) (on-table <x>)))");
  ASSERT_TRUE(cell.run_until("(goal-state 1 refused ?)", 60s));
  EXPECT_NE(write(cell.facts("(goal-state 1 refused ?)")[0]).find(why), std::string::npos)
      << write(cell.facts("(goal-state 1 refused ?)")[0]);
  const std::string said = want("(why-not (at-least 9 (<x> OBJECT) (on-table <x>)))");
  EXPECT_NE(said.find("the goal wants 9 of the type OBJECT, and there are only 3"), std::string::npos) << said;
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

TEST_F(Goals, ForAnObjectOfAKeptGoalThatIsMissingTheArmRestsAfterOneSearch) {
  want("(goal (keep (on circle triangle)))");
  ASSERT_TRUE(cell.run_until("(goal-state 1 kept ?)", 60s));
  cell.hidden = {"circle"};
  ASSERT_TRUE(cell.run_until("(goal-state 1 running (missing circle))", 300s));
  const int motions = cell.motions;
  // Nobody has moved an object that is hard to see.
  cell.hidden.insert("square");
  cell.run_for(600s);
  cell.hidden.erase("square");
  cell.run_for(600s);
  EXPECT_EQ(cell.motions, motions);
  EXPECT_EQ(cell.facts("(goal-state 1 running (missing circle))").size(), 1U);
  cell.cubes["circle"] = {450, -170, 30};
  cell.hidden.clear();
  ASSERT_TRUE(cell.run_until("(goal-state 1 kept ?)", 60s));
  EXPECT_TRUE(stands_on("circle", "triangle"));
}

TEST_F(Goals, WhatIsMissingOfAKeptGoalIsLookedForAgainOnceSomebodyMovedAnotherObject) {
  want("(goal (keep (on circle triangle)))");
  ASSERT_TRUE(cell.run_until("(goal-state 1 kept ?)", 60s));
  cell.hidden = {"circle"};
  ASSERT_TRUE(cell.run_until("(goal-state 1 running (missing circle))", 300s));
  const int motions = cell.motions;
  cell.run_for(30s);
  cell.cubes["square"] += Eigen::Vector3d(0, 40, 0);
  ASSERT_TRUE(cell.run_until("(event ? missing \"square was moved: what is missing is looked for again\" ?)", 10s));
  ASSERT_TRUE(cell.run_until("(goal-state 1 running (missing circle))", 300s));
  EXPECT_GT(cell.motions, motions);
  const int again = cell.motions;
  cell.run_for(600s);
  EXPECT_EQ(cell.motions, again);
}

TEST_F(Goals, AnotherGoalIsTakenUpWhileAnObjectOfAKeptOneIsMissing) {
  want("(goal (keep (on circle triangle)))");
  ASSERT_TRUE(cell.run_until("(goal-state 1 kept ?)", 60s));
  cell.hidden = {"circle"};
  ASSERT_TRUE(cell.run_until("(goal-state 1 running (missing circle))", 300s));
  want("(goal (on square triangle))");
  ASSERT_TRUE(cell.run_until("(goal-state 2 reached ?)", 60s));
  EXPECT_EQ(cell.facts("(goal-state 1 replaced ?)").size(), 1U);
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

TEST_F(Goals, ANewLifeGoesOnWithTheStageWhoseObjectIsWaitedFor) {
  want("(goal (then (on circle triangle) (on-table circle) (on square triangle)) (wait 600))");
  ASSERT_TRUE(cell.run_until("(goal-state 1 running (stage 3))", 120s));
  cell.hidden = {"square"};
  ASSERT_TRUE(cell.run_until("(goal-state 1 running (stage 3 (missing square)))", 120s));
  cell.stop_coordinator();
  cell.run_for(5s);
  cell.start_coordinator();
  cell.run_for(30s);
  cell.hidden.clear();
  ASSERT_TRUE(cell.run_until("(goal-state 1 reached ?)", 120s));
  EXPECT_TRUE(stands_on("square", "triangle"));
  EXPECT_FALSE(stands_on("circle", "triangle"));
}

TEST_F(Goals, WaitingHasAnEnd) {
  cell.hidden = {"circle"};
  want("(goal (on circle square) (wait 10))");
  ASSERT_TRUE(cell.run_until("(goal-state 1 refused ?)", 60s));
  EXPECT_EQ(cell.facts("(goal-state 1 refused ?)")[0][3][1], "missing-object"_sym);
}

}  // namespace
}  // namespace pizarra::coordinator
