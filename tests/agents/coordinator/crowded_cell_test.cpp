// A missing cube that another one hides: what is set aside, where to, and what is tried again.

#include <gtest/gtest.h>

#include "tests/agents/coordinator/fake_cell.hpp"

namespace pizarra::coordinator {
namespace {

TEST(CrowdedCell, SetsAsideWhatStandsBeforeThePlaceWhereAMissingCubeWasSeenLast) {
  FakeCell cell("blocks.scm", {{"circle", {410, -100, 30}}, {"triangle", {450, -40, 30}}, {"square", {450, 100, 30}}});
  cell.start_coordinator();
  cell.request("coordinator", "(goal (on-table square))");
  ASSERT_TRUE(cell.run_until("(goal-state 1 reached ?)", 30s));
  cell.hidden.insert("circle");
  cell.run_for(3s);
  cell.request("coordinator", "(goal (on circle square))");
  ASSERT_TRUE(cell.run_until("(event ? servo \"setting triangle aside, to see what it hides\" ?)", 30s));
  ASSERT_TRUE(cell.run_until("(gripper robot 60.0)", 30s));
  cell.hidden.clear();
  ASSERT_TRUE(cell.run_until("(goal-state 2 reached ?)", 60s));
}

// Far out to the side the eyes look along a slanting line: what hides a cube there stands nearer the middle than it.
TEST(CrowdedCell, LaysWhatItSetsAsideWhereItHidesTheMissingCubeNoMore) {
  FakeCell cell("blocks.scm", {{"circle", {289, -239, 30}}, {"triangle", {450, 0, 30}}, {"square", {450, 150, 30}}});
  cell.start_coordinator();
  cell.request("coordinator", "(goal (on-table circle))");
  ASSERT_TRUE(cell.run_until("(goal-state 1 reached ?)", 30s));
  cell.cubes["square"] = {450, -190, 30};
  cell.covered = [&cell](const std::string& name) {
    const Eigen::Vector3d& before = cell.cubes["square"];
    const Eigen::Vector3d& circle = cell.cubes["circle"];
    const double looks_past = circle.y() * (1330 - before.x()) / (1330 - circle.x());
    return name == "circle" && circle.z() < 60 && before.z() < 60 && std::abs(before.y() - looks_past) < 52;
  };
  cell.run_for(3s);
  cell.request("coordinator", "(goal (on circle triangle))");
  ASSERT_TRUE(cell.run_until("(goal-state 2 reached ?)", 120s));
  EXPECT_EQ(cell.times_told("(event ? servo \"setting square aside, to see what it hides\" ?)"), 1);
}

// Two hide it, so that it does not show either while one of them is held up.
TEST(CrowdedCell, LaysWhatItSetsAsideAwayFromWhereItStood) {
  FakeCell cell("blocks.scm", {{"circle", {420, -100, 30}}, {"triangle", {470, -50, 30}}, {"square", {470, 60, 30}}});
  cell.start_coordinator();
  cell.request("coordinator", "(goal (on-table circle))");
  ASSERT_TRUE(cell.run_until("(goal-state 1 reached ?)", 30s));
  cell.cubes["circle"] = {385, 0, 30};
  const auto hides = [&cell](const std::string& name) {
    const Eigen::Vector3d& at = cell.cubes[name];
    return at.z() < 120 && at.x() > 420 && std::abs(at.y()) < 70;
  };
  cell.covered = [&](const std::string& name) { return name == "circle" && (hides("triangle") || hides("square")); };
  cell.run_for(3s);
  cell.request("coordinator", "(goal (on circle square))");
  EXPECT_TRUE(cell.run_until("(goal-state 2 reached ?)", 120s));
}

// The one spot that is left leads the lines of sight just past the missing cube.
TEST(CrowdedCell, LaysWhatItSetsAsideWhereTheEyesJustLookPastIt) {
  FakeCell cell("blocks.scm", {{"circle", {353, 136, 30}},
                               {"triangle", {405, 62, 30}},
                               {"square", {449, -139, 30}},
                               {"cross", {450, -39, 30}}});
  cell.start_coordinator();
  cell.request("coordinator", "(goal (on-table circle))");
  ASSERT_TRUE(cell.run_until("(goal-state 1 reached ?)", 30s));
  cell.covered = [&cell](const std::string& name) {
    const Eigen::Vector3d& triangle = cell.cubes["triangle"];
    return name == "circle" && triangle.z() < 60 && triangle.y() > 50 && triangle.y() < 180;
  };
  cell.run_for(3s);
  cell.request("coordinator", "(goal (on circle square))");
  EXPECT_TRUE(cell.run_until("(goal-state 2 reached ?)", 120s));
  EXPECT_EQ(cell.times_told("(event ? servo \"setting triangle aside, to see what it hides\" ?)"), 1);
}

// All that is free hides what may stand behind the old place.
TEST(CrowdedCell, LaysWhatItSetsAsideElsewhereThoughNoSpotLeavesAllInSight) {
  FakeCell cell(
      "blocks.scm",
      {{"circle", {450, -140, 30}}, {"triangle", {450, 165, 30}}, {"square", {360, -5, 30}}, {"cross", {460, 40, 30}}});
  cell.start_coordinator();
  cell.request("coordinator", "(goal (on-table square))");
  ASSERT_TRUE(cell.run_until("(goal-state 1 reached ?)", 30s));
  cell.covered = [&cell](const std::string& name) {
    const Eigen::Vector3d& cross = cell.cubes["cross"];
    return name == "square" && cross.z() < 60 && cross.x() > 400 && std::abs(cross.y() + 5) < 60;
  };
  cell.run_for(3s);
  cell.request("coordinator", "(goal (on square circle))");
  EXPECT_TRUE(cell.run_until("(goal-state 2 reached ?)", 120s));
  EXPECT_EQ(cell.times_told("(event ? servo \"the rescue failed: cross lies where it lay\" ?)"), 0);
}

// A coordinator that was killed has seen nothing of it, and its plan tells that it was there.
TEST(CrowdedCell, LooksAfterARestartBehindACubeThatStandsAlone) {
  FakeCell cell("blocks.scm", {{"circle", {410, -100, 30}}, {"triangle", {450, 60, 30}}, {"square", {450, 160, 30}}});
  cell.start_coordinator();
  cell.request("coordinator", "(goal (on circle triangle))");
  ASSERT_TRUE(cell.run_until("(operation 0 ? running)", 30s));
  cell.stop_coordinator();
  cell.cubes["circle"] = {380, 140, 30};
  cell.covered = [&cell](const std::string& name) {
    const Eigen::Vector3d& square = cell.cubes["square"];
    return name == "circle" && square.z() < 60 && std::abs(square.y() - 160) < 40;
  };
  cell.start_coordinator();
  ASSERT_TRUE(cell.run_until("(goal-state 1 reached ?)", 120s));
  EXPECT_EQ(cell.times_told("(event ? servo \"setting square aside, to see what it hides\" ?)"), 1);
}

// The plan stacks triangle on square, where it hides circle, and grasps circle next.
TEST(CrowdedCell, SetsAsideTooWhatTheHidingCubeIsStackedOnAgain) {
  FakeCell cell("blocks.scm", {{"circle", {410, -100, 30}}, {"triangle", {450, 60, 30}}, {"square", {480, -100, 30}}});
  cell.start_coordinator();
  cell.covered = [&cell](const std::string& name) {
    const Eigen::Vector3d& triangle = cell.cubes["triangle"];
    const bool before = std::abs(triangle.y() + 100) < 50 && triangle.x() > 450;
    return name == "circle" && before && triangle.z() < 120;
  };
  cell.request("coordinator", "(goal (on circle triangle) (on triangle square))");
  ASSERT_TRUE(cell.run_until("(goal-state 1 reached ?)", 170s));
  EXPECT_EQ(cell.times_told("(event ? servo \"setting square aside, to see what it hides\" ?)"), 1);
}

TEST(CrowdedCell, RefusesWhatShowsOnlyWhileTheCubeBeforeItIsHeldUp) {
  FakeCell cell("blocks.scm", {{"circle", {410, -100, 30}}, {"triangle", {450, -40, 30}}, {"square", {450, 100, 30}}});
  cell.start_coordinator();
  cell.request("coordinator", "(goal (on-table circle))");
  ASSERT_TRUE(cell.run_until("(goal-state 1 reached ?)", 30s));
  cell.covered = [&cell](const std::string& name) { return name == "circle" && cell.cubes["triangle"].z() < 60; };
  cell.run_for(3s);
  cell.request("coordinator", "(goal (on circle square))");
  ASSERT_TRUE(cell.run_until("(goal-state 2 refused ?)", 400s));
  EXPECT_EQ(cell.facts("(goal-state 2 refused ?)")[0][3][1], "missing-object"_sym);
  EXPECT_LE(cell.times_told("(event ? servo \"setting triangle aside, to see what it hides\" ?)"), 10);
}

TEST(CrowdedCell, SetsTheSameCubeAsideAgainWhereTheArmWasStoppedTheFirstTime) {
  FakeCell cell("blocks.scm", {{"circle", {410, -100, 30}}, {"triangle", {450, -40, 30}}, {"square", {450, 100, 30}}});
  cell.start_coordinator();
  cell.request("coordinator", "(goal (on-table square))");
  ASSERT_TRUE(cell.run_until("(goal-state 1 reached ?)", 30s));
  cell.hidden.insert("circle");
  cell.run_for(3s);
  cell.request("coordinator", "(goal (on circle square))");
  ASSERT_TRUE(cell.run_until("(event ? servo \"setting triangle aside, to see what it hides\" ?)", 30s));
  cell.refusal = "stopped";
  ASSERT_TRUE(cell.run_until("(event ? servo \"the rescue failed: the test has the robot refuse\" ?)", 30s));
  cell.refusal.clear();
  ASSERT_TRUE(cell.run_until("(gripper robot 60.0)", 30s));
  cell.hidden.clear();
  EXPECT_TRUE(cell.run_until("(goal-state 2 reached ?)", 60s));
}

TEST(CrowdedCell, SetsTheSameCubeAsideAgainWhereItSlippedFromTheFingers) {
  const Eigen::Vector3d before(450, -40, 30);
  FakeCell cell("blocks.scm", {{"circle", {410, -100, 30}}, {"triangle", before}, {"square", {450, 100, 30}}});
  cell.start_coordinator();
  cell.request("coordinator", "(goal (on-table circle))");
  ASSERT_TRUE(cell.run_until("(goal-state 1 reached ?)", 30s));
  cell.covered = [&cell, before](const std::string& name) {
    return name == "circle" && (cell.cubes["triangle"] - before).head<2>().norm() < 30;
  };
  cell.run_for(3s);
  cell.request("coordinator", "(goal (on circle square))");
  ASSERT_TRUE(cell.run_until("(event ? servo \"setting triangle aside, to see what it hides\" ?)", 30s));
  ASSERT_TRUE(cell.run_until("(gripper robot 60.0)", 30s));
  cell.held.clear();
  cell.cubes["triangle"] = before;
  EXPECT_TRUE(cell.run_until("(goal-state 2 reached ?)", 120s));
  EXPECT_EQ(cell.times_told("(event ? servo \"setting triangle aside, to see what it hides\" ?)"), 2);
}

TEST(CrowdedCell, SetsTheSameCubeAsideAtTheFourthTryWhereTheFirstThreeMovedIt) {
  FakeCell cell("blocks.scm", {{"circle", {410, -100, 30}}, {"triangle", {450, -40, 30}}, {"square", {450, 100, 30}}});
  cell.start_coordinator();
  cell.request("coordinator", "(goal (on-table circle))");
  ASSERT_TRUE(cell.run_until("(goal-state 1 reached ?)", 30s));
  cell.covered = [&cell](const std::string& name) {
    return name == "circle" && std::abs(cell.cubes["triangle"].y() + 40) < 50;
  };
  cell.lowest_mm = 100;
  cell.run_for(3s);
  cell.request("coordinator", "(goal (on circle square))");
  constexpr int steps = 300;
  for (int tries = 1; tries <= 3; ++tries) {
    const auto failed = [&] {
      return cell.times_told("(event ? servo \"the rescue failed: the arm feels a collision\" ?)") >= tries;
    };
    for (int i = 0; i < steps && !failed(); ++i) cell.run_for(100ms);
    ASSERT_TRUE(failed());
    cell.cubes["triangle"].x() -= 15;
  }
  cell.lowest_mm = 0;
  EXPECT_TRUE(cell.run_until("(goal-state 2 reached ?)", 60s));
}

// The circle falls before the square, and is wanted on it.
TEST(CrowdedCell, GraspsWhatFellBeforeAnotherWithoutSettingItAside) {
  FakeCell cell("blocks.scm", {{"circle", {410, -100, 30}}, {"square", {450, 100, 30}}});
  cell.start_coordinator();
  cell.request("coordinator", "(goal (on circle square))");
  ASSERT_TRUE(cell.run_until("(operation ? (STACK circle square) running)", 60s));
  cell.slip();
  cell.cubes["circle"] = {530, 95, 30};
  cell.covered = [&](const std::string& name) { return name == "square" && cell.cubes["circle"].x() > 500; };
  ASSERT_TRUE(cell.run_until("(operation ? (PICK-UP circle) running)", 5s));
  EXPECT_TRUE(cell.run_until("(goal-state 1 reached ?)", 30s));
  EXPECT_TRUE(cell.facts("(event ? servo \"setting circle aside, to see what it hides\" ?)").empty());
}

// The circle hides the square, which the goal is about, and is set aside first.
TEST(CrowdedCell, ReachesNoGoalThatDoesNotShow) {
  FakeCell cell("blocks.scm", {{"circle", {410, -100, 30}}, {"square", {450, 100, 30}}});
  cell.start_coordinator();
  cell.request("coordinator", "(goal (on-table circle) (on-table square))");
  ASSERT_TRUE(cell.run_until("(goal-state 1 reached ?)", 30s));
  cell.cubes["circle"] = {530, 95, 30};
  cell.covered = [&](const std::string& name) { return name == "square" && cell.cubes["circle"].x() > 500; };
  cell.run_for(2s);
  cell.request("coordinator", "(goal (on-table square))");
  EXPECT_TRUE(cell.run_until("(event ? servo \"setting circle aside, to see what it hides\" ?)", 10s));
  EXPECT_TRUE(cell.facts("(goal-state 2 reached ?)").empty());
  EXPECT_TRUE(cell.run_until("(goal-state 2 reached ?)", 60s));
}

TEST(CrowdedCell, SearchesSoonForACubeThatFellOutOfSightAndWaitsNotUntilItLiesStill) {
  FakeCell cell("blocks.scm", {{"circle", {410, -100, 30}}, {"triangle", {450, -40, 30}}, {"square", {450, 100, 30}}});
  cell.start_coordinator();
  cell.request("coordinator", "(goal (on circle square))");
  ASSERT_TRUE(cell.run_until("(operation ? (STACK circle square) running)", 60s));
  cell.held.clear();
  cell.opening_mm = 0;
  cell.cubes["circle"] = {410, -40, 30};
  cell.hidden.insert("circle");
  ASSERT_TRUE(cell.run_until("(event ? difference ? ?)", 10s));
  EXPECT_TRUE(cell.run_until("(event ? servo \"setting triangle aside, to see what it hides\" ?)", 2s));
}

TEST(CrowdedCell, GraspsAgainAtOnceWhatSlipsWhileItIsSetAside) {
  FakeCell cell("blocks.scm", {{"circle", {410, -100, 30}}, {"triangle", {450, -40, 30}}, {"square", {450, 100, 30}}});
  cell.start_coordinator();
  cell.request("coordinator", "(goal (on-table circle))");
  ASSERT_TRUE(cell.run_until("(goal-state 1 reached ?)", 30s));
  cell.cubes["circle"] = {390, -40, 30};
  cell.covered = [&cell](const std::string& name) {
    return name == "circle" && cell.cubes["triangle"].z() < 60 && std::abs(cell.cubes["triangle"].y() + 40) < 50;
  };
  cell.run_for(3s);
  cell.request("coordinator", "(goal (on circle square))");
  const std::string_view sets_aside = "(event ? servo \"setting triangle aside, to see what it hides\" ?)";
  ASSERT_TRUE(cell.run_until(sets_aside, 30s));
  for (int i = 0; i < 3; ++i) {
    ASSERT_TRUE(cell.run_until("(gripper robot 60.0)", 6s)) << i;
    cell.run_for(150ms);
    cell.slip();
  }
  EXPECT_TRUE(cell.run_until("(goal-state 2 reached ?)", 60s));
  EXPECT_EQ(cell.times_told(sets_aside), 1);
}

// The circle is found, comes to lie where the images cut it off, and is wanted then.
void expect_built_after_it_came_to(FakeCell& cell, const Eigen::Vector3d& place_mm) {
  cell.start_coordinator();
  cell.request("coordinator", "(goal (on-table circle))");
  ASSERT_TRUE(cell.run_until("(goal-state 1 reached ?)", 30s));
  cell.cubes["circle"] = place_mm;
  cell.run_for(3s);
  cell.request("coordinator", "(goal (on circle square))");
  EXPECT_TRUE(cell.run_until("(goal-state 2 reached ?)", 120s));
}

TEST(CrowdedCell, SweepsACubeInThatCameToLieBesideTheImages) {
  FakeCell cell("blocks.scm", {{"circle", {450, -190, 30}}, {"square", {450, 100, 30}}});
  cell.covered = [&cell](const std::string& name) { return std::abs(cell.cubes[name].y()) > 240; };
  expect_built_after_it_came_to(cell, {430, -290, 30});
}

TEST(CrowdedCell, LiftsACubeThatTheLowerBorderOfTheImagesCutsOff) {
  FakeCell cell("blocks.scm", {{"circle", {530, -60, 30}}, {"square", {450, 100, 30}}});
  cell.covered = [&cell](const std::string& name) { return cell.cubes[name].x() > 590; };
  expect_built_after_it_came_to(cell, {605, -60, 30});
}

// The camera was knocked against, so that the circle is not recognised any more where it lay all the time.
TEST(CrowdedCell, SweepsInWhatTheImagesCutOffBeforeItSetsOthersAside) {
  FakeCell cell("blocks.scm", {{"circle", {450, -280, 30}}, {"square", {450, -100, 30}}, {"cross", {450, 100, 30}}});
  cell.start_coordinator();
  cell.request("coordinator", "(goal (on-table circle))");
  ASSERT_TRUE(cell.run_until("(goal-state 1 reached ?)", 30s));
  cell.covered = [&cell](const std::string& name) { return std::abs(cell.cubes[name].y()) > 240; };
  cell.run_for(3s);
  cell.request("coordinator", "(goal (on circle cross))");
  EXPECT_TRUE(cell.run_until("(goal-state 2 reached ?)", 60s));
  EXPECT_EQ(cell.times_told("(event ? servo \"setting square aside, to see what it hides\" ?)"), 0);
}

TEST(CrowdedCell, LooksForWhatItHeldWhereItWasLaidDownBeforeItSetsOthersAside) {
  FakeCell cell("blocks.scm", {{"circle", {450, -100, 30}}, {"square", {450, 100, 30}}});
  const std::string laying_down = "(event ? servo \"laying down what the gripper holds\" ?)";
  cell.covered = [&](const std::string& name) { return name == cell.held && cell.times_told(laying_down) == 0; };
  cell.start_coordinator();
  cell.request("coordinator", "(goal (on circle square))");
  EXPECT_TRUE(cell.run_until("(goal-state 1 reached ?)", 120s));
  EXPECT_EQ(cell.times_told(laying_down), 1);
  EXPECT_EQ(cell.times_told("(event ? servo \"setting square aside, to see what it hides\" ?)"), 0);
}

// The eyes still know the circle by a part of its mark. What is carried above it is out of view.
TEST(CrowdedCell, BringsACubeIntoViewThatTheImagesCutOffBeforeItStacksOnIt) {
  FakeCell cell("blocks.scm", {{"circle", {450, -285, 30}}, {"square", {450, 100, 30}}});
  cell.covered = [&cell](const std::string& name) { return name == cell.held && cell.cubes[name].y() < -240; };
  cell.start_coordinator();
  cell.request("coordinator", "(goal (on square circle))");
  EXPECT_TRUE(cell.run_until("(goal-state 1 reached ?)", 120s));
}

// The eyes know the place of the circle's mark by a part of it, not well enough to stack on.
TEST(CrowdedCell, BringsACubeIntoViewOnWhichAnotherDidNotStay) {
  FakeCell cell("blocks.scm", {{"circle", {450, -285, 30}}, {"square", {450, 100, 30}}});
  cell.start_coordinator();
  cell.request("coordinator", "(goal (on square circle))");
  int fallen = 0;
  for (int steps = 0; steps < 1200 && cell.facts("(goal-state 1 reached ?)").empty(); ++steps) {
    cell.run_for(100ms);
    const bool put_down = cell.held.empty() && cell.cubes["square"].z() > 60;
    if (!put_down || cell.cubes["circle"].y() > -240) continue;
    cell.cubes["square"] = {450, 100, 30};
    ++fallen;
  }
  EXPECT_FALSE(cell.facts("(goal-state 1 reached ?)").empty());
  EXPECT_EQ(fallen, 1);
}

// The fingers move the cube that they meet on their way down.
TEST(CrowdedCell, GoesDownAgainWhereACollisionEndedTheWayDownToACubeBeforeTheImages) {
  FakeCell cell("blocks.scm", {{"circle", {530, -60, 30}}, {"square", {450, 100, 30}}});
  cell.covered = [&cell](const std::string& name) { return cell.cubes[name].x() > 590; };
  cell.start_coordinator();
  cell.request("coordinator", "(goal (on-table circle))");
  ASSERT_TRUE(cell.run_until("(goal-state 1 reached ?)", 30s));
  cell.cubes["circle"] = {605, -60, 30};
  cell.run_for(3s);
  cell.request("coordinator", "(goal (on circle square))");
  ASSERT_TRUE(cell.run_until(
      "(event ? servo \"sweeping at the border of the images, where circle may lie or be hidden\" ?)", 120s));
  constexpr int steps = 100;
  for (int i = 0; i < steps && cell.grip.x() < 600; ++i) cell.run_for(50ms);
  ASSERT_GE(cell.grip.x(), 600) << "the fingers are above it";
  cell.refusal = "stopped";
  ASSERT_TRUE(cell.run_until("(event ? servo \"the rescue failed: the test has the robot refuse\" ?)", 30s));
  cell.refusal.clear();
  EXPECT_TRUE(cell.run_until("(goal-state 2 reached ?)", 120s));
}

TEST(CrowdedCell, TakesForMissingNoneThatShowsInSearchOfAnother) {
  FakeCell cell("blocks.scm", {{"circle", {450, -190, 30}}, {"square", {450, 190, 30}}});
  cell.start_coordinator();
  cell.request("coordinator", "(goal (on-table circle))");
  ASSERT_TRUE(cell.run_until("(goal-state 1 reached ?)", 30s));
  cell.hidden = {"circle", "square"};
  cell.run_for(3s);
  cell.request("coordinator", "(goal (on circle square))");
  ASSERT_TRUE(cell.run_until(
      "(event ? servo \"sweeping at the border of the images, where square may lie or be hidden\" ?)", 200s));
  cell.hidden.clear();
  EXPECT_TRUE(cell.run_until("(goal-state 2 reached ?)", 120s));
}

// The search for one shows the other too, if it is there.
TEST(CrowdedCell, DoesNothingTwiceInSearchOfTwoThatAreAway) {
  FakeCell cell("blocks.scm", {{"circle", {450, -190, 30}},
                               {"square", {450, -100, 30}},
                               {"triangle", {480, 0, 30}},
                               {"cross", {480, 120, 30}}});
  cell.start_coordinator();
  cell.request("coordinator", "(goal (on-table circle))");
  ASSERT_TRUE(cell.run_until("(goal-state 1 reached ?)", 30s));
  cell.hidden = {"circle", "square"};
  cell.cubes["circle"] = cell.cubes["square"] = {-5000, 0, 30};
  cell.run_for(3s);
  cell.request("coordinator", "(goal (on circle square))");
  ASSERT_TRUE(cell.run_until("(goal-state 2 refused ?)", 180s));
  EXPECT_EQ(cell.times_told("(event ? servo \"setting triangle aside, to see what it hides\" ?)"), 1);
  EXPECT_LE(cell.times_told("(event ? servo \"setting cross aside, to see what it hides\" ?)"), 1);
}

// The life that saw it is over, and its plan tells that it was there.
TEST(CrowdedCell, SweepsAfterARestartForWhatItHasNotSeenItself) {
  FakeCell cell("blocks.scm", {{"circle", {450, -190, 30}}, {"square", {450, 100, 30}}});
  cell.start_coordinator();
  cell.request("coordinator", "(goal (on circle square))");
  ASSERT_TRUE(cell.run_until("(operation 0 ? running)", 30s));
  cell.stop_coordinator();
  cell.hidden.insert("circle");
  cell.start_coordinator();
  EXPECT_TRUE(cell.run_until(
      "(event ? servo \"sweeping at the border of the images, where circle may lie or be hidden\" ?)", 120s));
}

TEST(CrowdedCell, RefusesWhatItSweepsForInVain) {
  FakeCell cell("blocks.scm", {{"circle", {450, -190, 30}}, {"square", {450, 100, 30}}});
  cell.start_coordinator();
  cell.request("coordinator", "(goal (on-table circle))");
  ASSERT_TRUE(cell.run_until("(goal-state 1 reached ?)", 30s));
  cell.hidden.insert("circle");
  cell.cubes["circle"] = {-5000, 0, 30};
  cell.run_for(3s);
  cell.request("coordinator", "(goal (on circle square))");
  ASSERT_TRUE(cell.run_until("(goal-state 2 refused ?)", 120s));
  EXPECT_EQ(cell.facts("(goal-state 2 refused ?)")[0][3][1], "missing-object"_sym);
  EXPECT_GE(
      cell.times_told("(event ? servo \"sweeping at the border of the images, where circle may lie or be hidden\" ?)"),
      1);
}

TEST(CrowdedCell, LooksBehindWhatStandsBeforeAMissingCubeThoughTheEyesWereAwayForLong) {
  FakeCell cell("blocks.scm", {{"circle", {410, -100, 30}}, {"triangle", {450, -40, 30}}, {"square", {450, 100, 30}}});
  cell.start_coordinator();
  cell.request("coordinator", "(goal (on-table square))");
  ASSERT_TRUE(cell.run_until("(goal-state 1 reached ?)", 30s));
  cell.hidden.insert("circle");
  cell.run_for(3s);
  cell.request("coordinator", "(goal (on circle square))");
  cell.run_for(2s);
  cell.stop_vision();
  cell.run_for(8s);
  cell.start_vision();
  ASSERT_TRUE(cell.run_until("(event ? servo \"setting triangle aside, to see what it hides\" ?)", 30s));
}

TEST(CrowdedCell, RaisesTheArmFromBeforeAMissingCubeAgainWhereItWasStoppedOnTheWay) {
  FakeCell cell("blocks.scm", {{"circle", {450, -100, 30}}, {"square", {450, 100, 30}}});
  cell.grip.z() = 100;
  bool is_raised = false;
  cell.covered = [&](const std::string& name) {
    is_raised = is_raised || cell.grip.z() > 250;
    return name == "circle" && !is_raised;
  };
  cell.start_coordinator();
  cell.refusal = "stopped";
  cell.request("coordinator", "(goal (on circle square))");
  cell.run_for(2500ms);
  EXPECT_TRUE(cell.facts("(goal-state 1 refused ?)").empty());
  cell.refusal.clear();
  EXPECT_TRUE(cell.run_until("(goal-state 1 reached ?)", 60s));
}

TEST(NumberedPlacesCell, SwapsTwoCubesThroughAFreePlace) {
  FakeCell cell("numbered-places.scm", {{"circle", {450, -200, 30}}, {"square", {450, -100, 30}}});
  cell.start_coordinator();
  cell.request("coordinator", "(goal (at circle place-2) (at square place-1))");
  ASSERT_TRUE(cell.run_until("(goal-state 1 reached ?)", 120s));
  EXPECT_NEAR(cell.cubes["circle"].y(), -100, 3);
  EXPECT_NEAR(cell.cubes["square"].y(), -200, 3);
}

}  // namespace
}  // namespace pizarra::coordinator
