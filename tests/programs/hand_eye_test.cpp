#include "programs/commands/hand_eye.hpp"

#include <gtest/gtest.h>

#include "agents/launcher/readiness.hpp"
#include "blackboard/time/virtual_executor.hpp"
#include "drivers/arm/arm_file.hpp"
#include "lisp/guile/interpret.hpp"
#include "tests/source_dir.hpp"

namespace pizarra::programs {
namespace {

const coordinator::CameraModel model;
const forms::CameraPose truth{{1318, 12, 210}, 1.2, -1.2, 1};
const Eigen::Vector3d true_mark(31, 0.5, -66);
const forms::BelievedCamera guess{.pose = {}, .sure_mm = 20, .sure_deg = 2};

// The mark as it is seen, without noise, at the poses that the command would choose.
std::vector<coordinator::MarkPair> pairs_of(bool turned, std::size_t many) {
  const arm::ArmModel& arm = arm::crs_f3();
  const coordinator::CameraView expected(guess.pose, model);
  const CarryingRoom room{{330, -200, 150}, {570, 200, 330}};
  std::vector<coordinator::MarkPair> pairs;
  for (const CarriedPose& pose : poses_to_carry_to(arm, expected, true_mark, room, 70, many)) {
    const double yaw = turned ? pose.yaw_deg : 0;
    const Eigen::Isometry3d tool = coordinator::tool_pose(pose.grip_mm, 180, turned ? pose.tilt_deg : 0, yaw);
    const coordinator::CameraView view(truth, model);
    pairs.push_back({tool, {}, coordinator::seen_mark(view, tool * true_mark), 10});
  }
  return pairs;
}

double apart(const forms::CameraPose& one, const forms::CameraPose& other) {
  return std::hypot(one.at_mm[0] - other.at_mm[0], one.at_mm[1] - other.at_mm[1], one.at_mm[2] - other.at_mm[2]);
}

TEST(HandEye, ChoosesPosesWithinReachAndViewThatAreTurned) {
  const arm::ArmModel& arm = arm::crs_f3();
  const coordinator::CameraView view(guess.pose, model);
  const CarryingRoom room{{330, -200, 150}, {570, 200, 330}};
  const std::vector<CarriedPose> poses = poses_to_carry_to(arm, view, {30, 0, -66}, room, 70, 28);
  ASSERT_EQ(poses.size(), 28U);
  double least_yaw = 0, most_yaw = 0;
  for (const CarriedPose& pose : poses) {
    EXPECT_TRUE(view.shows(pose.grip_mm + Eigen::Vector3d(30, 0, 66), 30));
    least_yaw = std::min(least_yaw, pose.yaw_deg);
    most_yaw = std::max(most_yaw, pose.yaw_deg);
  }
  EXPECT_GE(most_yaw - least_yaw, 40);
}

TEST(HandEye, ChoosesNoneWhereTheCameraLooksElsewhere) {
  const CarryingRoom room{{330, -200, 150}, {570, 200, 330}};
  const coordinator::CameraView away(forms::CameraPose{{1330, 0, 200}, 50, 0, 0}, model);
  EXPECT_TRUE(poses_to_carry_to(arm::crs_f3(), away, {30, 0, -66}, room, 70, 28).empty());
}

TEST(HandEye, FindsTheCameraAndTheMarkOnTheTool) {
  const Result<HandEyeResult> found = solve_hand_eye(guess, pairs_of(true, 28), 28, model);
  ASSERT_TRUE(found) << describe(found.error());
  EXPECT_LT(apart(found->camera.pose, truth), 0.5);
  EXPECT_NEAR(found->camera.pose.pan_deg, truth.pan_deg, 0.05);
  EXPECT_NEAR(found->camera.pose.tilt_deg, truth.tilt_deg, 0.05);
  EXPECT_NEAR(found->camera.pose.roll_deg, truth.roll_deg, 0.05);
  for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(found->camera.mark_mm[axis], true_mark[axis], 0.5);
  EXPECT_EQ(found->poses, 21U);
  EXPECT_EQ(found->held_back, 7U);
}

TEST(HandEye, RefusesASetThatTellsTooLittleAndSaysWhatToDo) {
  const Result<HandEyeResult> hidden = solve_hand_eye(guess, pairs_of(true, 8), 28, model);
  ASSERT_FALSE(hidden);
  EXPECT_EQ(hidden.error().symbol, "mark-hidden");
  EXPECT_NE(hidden.error().sentence.find("8 of 28 poses"), std::string::npos) << hidden.error().sentence;
  const Result<HandEyeResult> unturned = solve_hand_eye(guess, pairs_of(false, 28), 28, model);
  ASSERT_FALSE(unturned);
  EXPECT_EQ(unturned.error().symbol, "too-little-turning");
}

TEST(HandEye, RefusesPairsThatDoNotBelongTogether) {
  std::vector<coordinator::MarkPair> pairs = pairs_of(true, 28);
  for (std::size_t i = 0; i < pairs.size(); ++i) pairs[i].seen.x() += i % 2 == 0 ? 25 : -25;
  const Result<HandEyeResult> found = solve_hand_eye(guess, pairs, 28, model);
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().symbol, "uncertain");
}

TEST(HandEye, WritesWhatACellReads) {
  const forms::BelievedCamera camera{.pose = truth, .sure_mm = 0.4, .sure_deg = 0.03, .mark_mm = {31, 0.5, -66}};
  const Result<Source> source = read_source(write_believed_camera(camera), "camera-pose.scm");
  ASSERT_TRUE(source);
  const Result<Datum> read = guile::interpret(*source, "camera-pose");
  ASSERT_TRUE(read) << describe(read.error());
  EXPECT_DOUBLE_EQ((*read)[0][3].number(), 1.2);
  EXPECT_DOUBLE_EQ((*read)[1][0].number(), 0.4);
  EXPECT_DOUBLE_EQ((*read)[2][1].number(), 0.5);
}

Task<void> find(launcher::LocalCell& cell, Board& board, HandEye& hand_eye, Result<HandEyeResult>& found) {
  const std::vector<std::string> players{"robot", "vision", "person"};
  for (const std::string& kind : players) EXPECT_TRUE(cell.start(kind));
  const Result<void> there = co_await launcher::await_agents(cell, board, players);
  EXPECT_TRUE(there);
  const Result<void> taught = co_await launcher::await_teaching(board, cell.executor());
  EXPECT_TRUE(taught);
  found = co_await hand_eye.run();
}

TEST(HandEye, FindsTheSimulatedCameraWithinAMillimetreAndATenthOfADegree) {
  const forms::CellDescription description =
      forms::read_cell_file(source_dir() + "/tests/scenarios/cells/guessed-camera.scm").value();
  ASSERT_TRUE(launcher::world_config(description, 1));
  const arm::ArmModel arm = arm::read_arm_file(description.arm_file).value();
  VirtualExecutor executor;
  launcher::LocalCell cell(executor, description, 1);
  const std::unique_ptr<Board> board = cell.board().view("hand-eye");
  std::string told;
  HandEye hand_eye(executor, *board, cell.description(), arm, 28,
                   [&](const std::string& line) { told += line + "\n"; });
  Result<HandEyeResult> found = fail("unfinished", "it did not end");
  const Job job = executor.spawn(find(cell, *board, hand_eye, found));
  executor.run_until([&job] { return job.done(); });
  ASSERT_TRUE(found) << describe(found.error()) << "\n" << told;
  const forms::CameraPose& stands = description.world_camera;
  EXPECT_LT(apart(found->camera.pose, stands), 1) << told;
  EXPECT_NEAR(found->camera.pose.pan_deg, stands.pan_deg, 0.1);
  EXPECT_NEAR(found->camera.pose.tilt_deg, stands.tilt_deg, 0.1);
  EXPECT_NEAR(found->camera.pose.roll_deg, stands.roll_deg, 0.1);
}

}  // namespace
}  // namespace pizarra::programs
