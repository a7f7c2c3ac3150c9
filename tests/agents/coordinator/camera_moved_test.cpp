#include <gtest/gtest.h>

#include "agents/coordinator/geometry/camera_pose.hpp"
#include "lisp/writer.hpp"
#include "tests/agents/coordinator/fake_cell.hpp"

namespace pizarra::coordinator {
namespace {

class CameraMoved : public testing::Test {
 protected:
  static constexpr std::string_view measured = "(camera-pose ? ? ? ? ? ? measured ? ?)";

  void begin() { cell.start_coordinator(); }
  void want(std::string_view goal) { cell.request("coordinator", goal); }
  void bump() {
    cell.camera.at_mm[0] -= 15;
    cell.camera.at_mm[1] += 20;
    cell.camera.pan_deg += 1.5;
    cell.camera.tilt_deg -= 2;
  }
  void expect_on(const std::string& upper, const std::string& lower) {
    const Eigen::Vector3d apart = cell.cubes[upper] - cell.cubes[lower];
    EXPECT_LT(std::hypot(apart.x(), apart.y()), 6) << upper;
    EXPECT_NEAR(apart.z(), 60, 1) << upper;
  }
  void expect_found() {
    const std::vector<Datum> poses = cell.facts(measured);
    ASSERT_EQ(poses.size(), 1U) << write(Datum::list(cell.facts("(camera-pose ? ? ? ? ? ? ? ? ?)")));
    const Datum& told = poses[0];
    const forms::CameraPose found{.at_mm = {told[1].number(), told[2].number(), told[3].number()},
                                  .pan_deg = told[4].number(),
                                  .tilt_deg = told[5].number(),
                                  .roll_deg = told[6].number()};
    for (const double y_mm : {-150.0, 150.0}) {
      for (const double z_mm : {30.0, 150.0}) {
        EXPECT_LT(apart_mm(found, cell.camera, {450, y_mm, z_mm}), 5) << write(told) << " at " << y_mm << ' ' << z_mm;
      }
    }
  }

  FakeCell cell{"blocks.scm", {{"circle", {450, -150, 30}}, {"triangle", {455, -50, 30}}, {"square", {445, 50, 30}}}};
};

TEST_F(CameraMoved, AGuessIsFoundOutBeforeTheGoalIsPursued) {
  cell.believed = {.pose = {}, .sure_mm = 20, .sure_deg = 2};
  bump();
  begin();
  want("(goal (on circle triangle))");
  ASSERT_TRUE(cell.run_until("(goal-state 1 reached ?)", 120s)) << write(Datum::list(cell.facts("(goal-state ? ? ?)")));
  expect_on("circle", "triangle");
  expect_found();
  EXPECT_EQ(cell.times_told("(operation ? ? failed)"), 0);
}

TEST_F(CameraMoved, OneOfWhichNothingIsKnownIsFoundByPixelErrorsAlone) {
  cell.believed.unknown = true;
  cell.camera = {.at_mm = {1250, 220, 300}, .pan_deg = -14, .tilt_deg = -8, .roll_deg = 5};
  begin();
  want("(goal (on circle triangle))");
  ASSERT_TRUE(cell.run_until("(goal-state 1 reached ?)", 120s)) << write(Datum::list(cell.facts("(goal-state ? ? ?)")));
  expect_on("circle", "triangle");
  expect_found();
  EXPECT_GT(cell.times_told("(servo 1 end-effector ? ? ?)"), 0);
  EXPECT_EQ(cell.times_told("(operation ? ? failed)"), 0);
}

TEST_F(CameraMoved, ABumpInTheMiddleOfAGoalIsNoticedToldAndCorrected) {
  begin();
  want("(goal (on circle triangle) (on triangle square))");
  ASSERT_TRUE(cell.run_until("(operation ? (STACK triangle square) running)", 60s));
  bump();
  ASSERT_TRUE(cell.run_until("(goal-state 1 reached ?)", 240s)) << write(Datum::list(cell.facts("(goal-state ? ? ?)")));
  expect_on("circle", "triangle");
  expect_on("triangle", "square");
  EXPECT_GT(cell.times_told("(camera-pose ? ? ? ? ? ? doubtful ? ?)"), 0);
  expect_found();
}

TEST_F(CameraMoved, WhatWasMeasuredOutlivesARestart) {
  cell.believed = {.pose = {}, .sure_mm = 20, .sure_deg = 2};
  bump();
  begin();
  want("(goal (on circle triangle))");
  ASSERT_TRUE(cell.run_until("(goal-state 1 reached ?)", 120s));
  cell.stop_coordinator();
  cell.run_for(3s);
  begin();
  const int moved = cell.motions;
  want("(goal (on circle triangle))");
  ASSERT_TRUE(cell.run_until("(goal-state 2 reached ?)", 20s));
  EXPECT_EQ(cell.motions, moved) << "the camera's place is known";
}

TEST_F(CameraMoved, ADoubtOutlivesARestart) {
  begin();
  want("(goal (on circle triangle) (on triangle square))");
  ASSERT_TRUE(cell.run_until("(operation ? (STACK triangle square) running)", 60s));
  bump();
  ASSERT_TRUE(cell.run_until("(camera-pose ? ? ? ? ? ? doubtful ? ?)", 60s));
  const std::string_view where_it_stood = "(camera-pose 1330.0 0.0 200.0 0.0 0.0 0.0 measured ? ?)";
  const int believed_before = cell.times_told(where_it_stood);
  cell.stop_coordinator();
  cell.run_for(3s);
  begin();
  ASSERT_TRUE(cell.run_until(measured, 120s));
  expect_found();
  EXPECT_EQ(cell.times_told(where_it_stood), believed_before);
}

TEST_F(CameraMoved, AMotionThatEndsEarlyWhileItIsFoundOutIsMadeAgain) {
  cell.believed = {.pose = {}, .sure_mm = 20, .sure_deg = 2};
  bump();
  begin();
  cell.refusal = "stopped";
  want("(goal (on circle triangle))");
  cell.run_for(5s);
  EXPECT_TRUE(cell.facts("(goal-state 1 refused ?)").empty()) << write(Datum::list(cell.facts("(goal-state ? ? ?)")));
  cell.refusal.clear();
  ASSERT_TRUE(cell.run_until("(goal-state 1 reached ?)", 120s)) << write(Datum::list(cell.facts("(goal-state ? ? ?)")));
}

TEST_F(CameraMoved, ABumpAfterWhichTheMarkIsOutOfViewHighUpIsFoundOutFurtherDown) {
  begin();
  want("(goal (on circle triangle))");
  ASSERT_TRUE(cell.run_until("(operation ? (STACK circle triangle) running)", 60s));
  cell.camera.at_mm[2] -= 20;
  cell.camera.tilt_deg -= 4;
  ASSERT_TRUE(cell.run_until("(goal-state 1 reached ?)", 240s)) << write(Datum::list(cell.facts("(goal-state ? ? ?)")));
  expect_on("circle", "triangle");
  EXPECT_GT(cell.times_told("(camera-pose ? ? ? ? ? ? doubtful ? ?)"), 0);
  expect_found();
}

TEST_F(CameraMoved, AnArmWhoseWordComesLateIsNoReasonToDoubtTheCamera) {
  begin();
  cell.word_late = 1500ms;
  want("(goal (on circle triangle))");
  ASSERT_TRUE(cell.run_until("(goal-state 1 reached ?)", 240s)) << write(Datum::list(cell.facts("(goal-state ? ? ?)")));
  expect_on("circle", "triangle");
  EXPECT_EQ(cell.times_told("(camera-pose ? ? ? ? ? ? doubtful ? ?)"), 0);
}

// Its word goes with it, and the last of that is from the middle of the motion.
TEST_F(CameraMoved, AnArmWhoseAgentDiedInAMotionIsNoReasonToDoubtTheCamera) {
  begin();
  cell.word_late = 1s;
  want("(goal (on circle triangle))");
  ASSERT_TRUE(cell.run_until("(operation ? (STACK circle triangle) running)", 60s));
  ASSERT_TRUE(cell.run_until("(arm robot moving ?)", 10s));
  cell.run_for(50ms);
  cell.stop_robot();
  cell.forget("(arm robot ? ?)");
  cell.forget("(arm-pose robot ? ? ? ? ? ?)");
  cell.run_for(5s);
  EXPECT_EQ(cell.times_told("(camera-pose ? ? ? ? ? ? doubtful ? ?)"), 0);
}

TEST_F(CameraMoved, AMarkThatIsNeverSeenIsRefusedWithWhatToDo) {
  cell.believed = {.pose = {}, .sure_mm = 20, .sure_deg = 2};
  cell.mark_hidden = [] { return true; };
  begin();
  want("(goal (on circle triangle))");
  ASSERT_TRUE(cell.run_until("(goal-state 1 refused ?)", 240s));
  const Datum why = cell.facts("(goal-state 1 refused ?)")[0][3];
  EXPECT_EQ(why[1], "camera-moved"_sym) << write(why);
  EXPECT_NE(why[2].text().find("seen at 0 of 16 places"), std::string_view::npos) << write(why);
}

}  // namespace
}  // namespace pizarra::coordinator
