#include "programs/hand_eye/hand_eye.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <numbers>

#include "agents/launcher/agent_factory.hpp"
#include "blackboard/time/virtual_executor.hpp"
#include "drivers/arm/arm_file.hpp"
#include "lisp/guile/scheme.hpp"
#include "programs/hand_eye/hand_eye_poses.hpp"
#include "tests/source_dir.hpp"

namespace pizarra::hand_eye {
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
  const Result<HandEyeResult> found = solve_hand_eye(guess, {pairs_of(true, 28), 28}, model);
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
  const Result<HandEyeResult> hidden = solve_hand_eye(guess, {pairs_of(true, 8), 28}, model);
  ASSERT_FALSE(hidden);
  EXPECT_EQ(hidden.error().symbol, "mark-hidden");
  EXPECT_NE(hidden.error().sentence.find("8 of 28 poses"), std::string::npos) << hidden.error().sentence;
  const Result<HandEyeResult> unturned = solve_hand_eye(guess, {pairs_of(false, 28), 28}, model);
  ASSERT_FALSE(unturned);
  EXPECT_EQ(unturned.error().symbol, "too-little-turning");
}

TEST(HandEye, RefusesPairsThatDoNotBelongTogether) {
  std::vector<coordinator::MarkPair> pairs = pairs_of(true, 28);
  for (std::size_t i = 0; i < pairs.size(); ++i) pairs[i].seen.x() += i % 2 == 0 ? 25 : -25;
  const Result<HandEyeResult> found = solve_hand_eye(guess, {pairs, 28}, model);
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().symbol, "uncertain");
}

const forms::HeadAxes true_axes{.pan = {{7, 0, -41}, {0.03, 1, -0.02}}, .tilt = {{0, 54, -33}, {1, -0.015, 0.025}}};

// As pairs_of(), at some of the poses, with the head at the angles that the command would choose.
SeenPairs turned_pairs(double most_turn_deg = 90) {
  forms::CameraPose on_a_head = truth;
  on_a_head.axes = true_axes;
  const ptu::PanTiltRange range{{-159, 159, 0.05, 300}, {-46, 31, 0.05, 300}};
  const std::vector<coordinator::MarkPair> straight = pairs_of(true, 28);
  SeenPairs seen;
  for (std::size_t i = 0; i < straight.size(); i += 4) {
    const Eigen::Isometry3d& tool = straight[i].tool;
    for (const ptu::HeadTurn head : angles_to_turn_to(guess.pose, model, tool * true_mark, range, 70, 6)) {
      ++seen.tried;
      if (std::max(std::abs(head.pan_deg), std::abs(head.tilt_deg)) > most_turn_deg) continue;
      const coordinator::CameraView view(on_a_head, model, head);
      seen.pairs.push_back({tool, head, coordinator::seen_mark(view, tool * true_mark), 10});
    }
  }
  return seen;
}

Result<HandEyeResult> solved_with(const SeenPairs& turned) {
  const SeenPairs seen{pairs_of(true, 28), 28};
  const Result<HandEyeResult> unturned = solve_hand_eye(guess, seen, model);
  if (!unturned) return unturned;
  return solve_head(*unturned, seen, turned, model);
}

// How far an axis passes from where it should, mm, and by how many degrees it points elsewhere; in the base frame.
struct AxisError {
  double mm;
  double deg;
};
AxisError axis_error(const forms::CameraPose& found, forms::HeadAxis axis, const forms::CameraPose& stands,
                     forms::HeadAxis is) {
  const Eigen::Isometry3d found_frame = ptu::camera_frame(found);
  const Eigen::Isometry3d frame = ptu::camera_frame(stands);
  const Eigen::Vector3d apart =
      found_frame * Eigen::Vector3d(axis.at_mm.data()) - frame * Eigen::Vector3d(is.at_mm.data());
  const Eigen::Vector3d along = found_frame.linear() * Eigen::Vector3d(axis.along.data()).normalized();
  const Eigen::Vector3d true_along = frame.linear() * Eigen::Vector3d(is.along.data()).normalized();
  return {apart.cross(true_along).norm(), std::asin(along.cross(true_along).norm()) * 180 / std::numbers::pi};
}

TEST(HandEye, TurnsTheHeadToAnglesFarApartFromWhichTheMarkIsInView) {
  const ptu::PanTiltRange range{{-159, 159, 0.05, 300}, {-46, 3, 0.05, 300}};
  const Eigen::Vector3d mark(480, 60, 270);
  const std::vector<ptu::HeadTurn> angles = angles_to_turn_to(guess.pose, model, mark, range, 70, 6);
  ASSERT_EQ(angles.size(), 6U);
  const auto [least, most] = std::ranges::minmax(angles, {}, &ptu::HeadTurn::pan_deg);
  EXPECT_GE(most.pan_deg - least.pan_deg, 16);
  for (const ptu::HeadTurn angle : angles) {
    EXPECT_LE(angle.tilt_deg, 3) << "the unit tilts no further";
    EXPECT_TRUE(coordinator::CameraView(guess.pose, model, angle).shows(mark, 70));
  }
}

TEST(HandEye, FindsTheAxesAboutWhichAHeadTurns) {
  const Result<HandEyeResult> found = solved_with(turned_pairs());
  ASSERT_TRUE(found) << describe(found.error());
  const forms::CameraPose& pose = found->camera.pose;
  EXPECT_LT(apart(pose, truth), 0.2);
  ASSERT_TRUE(pose.axes);
  const AxisError pan = axis_error(pose, pose.axes->pan, truth, true_axes.pan);
  const AxisError tilt = axis_error(pose, pose.axes->tilt, truth, true_axes.tilt);
  EXPECT_LT(std::max(pan.mm, tilt.mm), 0.2);
  EXPECT_LT(std::max(pan.deg, tilt.deg), 0.02);
  EXPECT_GT(found->head->held_back, 5U);
  EXPECT_LT(found->head->checked_mm, 0.2);
}

TEST(HandEye, RefusesAnglesOfTheHeadThatTellTooLittleAndSaysWhatToDo) {
  SeenPairs hidden = turned_pairs();
  hidden.pairs.resize(7);
  const Result<HandEyeResult> few = solved_with(hidden);
  ASSERT_FALSE(few);
  EXPECT_EQ(few.error().symbol, "mark-hidden");
  EXPECT_NE(few.error().sentence.find("7 of 42 angles of the head"), std::string::npos) << few.error().sentence;
  SeenPairs level = turned_pairs();
  std::erase_if(level.pairs, [](const coordinator::MarkPair& pair) { return std::abs(pair.head.tilt_deg) > 3; });
  while (level.pairs.size() < 10) level.pairs.push_back(level.pairs.front());
  const Result<HandEyeResult> unturned = solved_with(level);
  ASSERT_FALSE(unturned);
  EXPECT_EQ(unturned.error().symbol, "too-little-turning");
}

TEST(HandEye, RefusesAHeadThatCountsTheOtherWayRound) {
  SeenPairs turned = turned_pairs();
  for (coordinator::MarkPair& pair : turned.pairs) pair.head.pan_deg = -pair.head.pan_deg;
  const Result<HandEyeResult> found = solved_with(turned);
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().symbol, "uncertain");
  EXPECT_NE(found.error().sentence.find("reversed"), std::string::npos) << found.error().sentence;
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

TEST(HandEye, WritesTheAxesOfAHeadAsACellReadsThem) {
  forms::BelievedCamera camera{.pose = truth, .sure_mm = 0.4, .sure_deg = 0.03};
  camera.pose.axes = true_axes;
  const Result<Source> source = read_source(write_believed_camera(camera), "camera-pose.scm");
  ASSERT_TRUE(source);
  const Result<Datum> read = guile::interpret(*source, "camera-pose");
  ASSERT_TRUE(read) << describe(read.error());
  EXPECT_DOUBLE_EQ((*read)[4][0][2].number(), -41);
  EXPECT_DOUBLE_EQ((*read)[4][3][1].number(), -0.015);
}

Task<void> find(launcher::LocalCell& cell, Board& board, HandEye& hand_eye, Result<HandEyeResult>& found) {
  found = co_await find_in_local_cell(cell, board, hand_eye);
}

// A cell of tests/scenarios/cells/, calibrated in virtual time.
struct CalibratedCell {
  explicit CalibratedCell(const std::string& file)
      : description(forms::read_cell_file(source_dir() + "/tests/scenarios/cells/" + file).value()) {
    const arm::ArmModel arm = arm::read_arm_file(description.arm_file).value();
    VirtualExecutor executor;
    launcher::LocalCell cell(executor, description, 1);
    const std::unique_ptr<Board> board = cell.board().view("hand-eye");
    HandEye hand_eye(executor, *board, cell.description(), arm, 28,
                     [&](const std::string& line) { told += line + "\n"; });
    const Job job = executor.spawn(find(cell, *board, hand_eye, found));
    executor.run_until([&job] { return job.done(); });
  }

  forms::CellDescription description;
  std::string told;
  Result<HandEyeResult> found = fail("unfinished", "it did not end");
};

void expect_found(const CalibratedCell& cell) {
  ASSERT_TRUE(cell.found) << describe(cell.found.error()) << "\n" << cell.told;
  const forms::CameraPose& stands = cell.description.world_camera;
  const forms::CameraPose& found = cell.found->camera.pose;
  EXPECT_LT(apart(found, stands), 1) << cell.told;
  EXPECT_NEAR(found.pan_deg, stands.pan_deg, 0.1);
  EXPECT_NEAR(found.tilt_deg, stands.tilt_deg, 0.1);
  EXPECT_NEAR(found.roll_deg, stands.roll_deg, 0.1);
}

TEST(HandEye, FindsTheSimulatedCameraWithinAMillimetreAndATenthOfADegree) {
  expect_found(CalibratedCell("guessed-camera.scm"));
}

TEST(HandEye, FindsTheAxesOfTheSimulatedHeadWithinAMillimetreAndATenthOfADegree) {
  const CalibratedCell cell("leaning-head.scm");
  ASSERT_NO_FATAL_FAILURE(expect_found(cell));
  const forms::CameraPose& stands = cell.description.world_camera;
  const forms::CameraPose& found = cell.found->camera.pose;
  const AxisError pan = axis_error(found, found.axes->pan, stands, stands.axes->pan);
  const AxisError tilt = axis_error(found, found.axes->tilt, stands, stands.axes->tilt);
  EXPECT_LT(pan.mm, 1) << cell.told;
  EXPECT_LT(tilt.mm, 1) << cell.told;
  EXPECT_LT(pan.deg, 0.1);
  EXPECT_LT(tilt.deg, 0.1);
}

}  // namespace
}  // namespace pizarra::hand_eye
