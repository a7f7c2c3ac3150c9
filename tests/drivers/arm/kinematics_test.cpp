#include "drivers/arm/kinematics.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>

#include "blackboard/time/random.hpp"
#include "drivers/arm/arm_file.hpp"

namespace pizarra::arm {
namespace {

constexpr std::uint64_t seed = 20240607;
// The CRS-F3's test cases, which hold without its track.
ArmModel without_track(ArmModel arm) {
  arm.axes.pop_back();
  arm.home = Joints(6);
  arm.ready = {0, 0, -90, 0, -90, 0};
  return arm;
}
const ArmModel model = without_track(crs_f3());

Joints random_joints(Random& random) {
  Joints joints(model.axes.size());
  for (std::size_t axis = 0; axis < joints.size(); ++axis) {
    joints[axis] = random.uniform(model.axes[axis].limits.low, model.axes[axis].limits.high);
  }
  return joints;
}

double angle_between_deg(const ToolPose& a, const ToolPose& b) {
  // From the chord, because the trace cannot tell angles below 1e-6 degree apart.
  const double chord = (a.linear() - b.linear()).norm() / std::sqrt(8.0);
  return 2 * std::asin(std::min(1.0, chord)) * 180 / std::numbers::pi;
}

ToolPose tool_down(double x, double y, double z, double turn_deg = 0) {
  ToolPose pose = ToolPose::Identity();
  pose.linear() = (Eigen::AngleAxisd(turn_deg * std::numbers::pi / 180, Eigen::Vector3d::UnitZ()) *
                   Eigen::AngleAxisd(std::numbers::pi, Eigen::Vector3d::UnitX()))
                      .toRotationMatrix();
  pose.translation() = Eigen::Vector3d(x, y, z);
  return pose;
}

TEST(Kinematics, StandsUprightWithAllJointsAtZero) {
  const ToolPose pose = forward(model, Joints(6));
  EXPECT_NEAR(pose.translation().x(), 100, 1e-9);
  EXPECT_NEAR(pose.translation().y(), 0, 1e-9);
  EXPECT_NEAR(pose.translation().z(), 350 + 265 + 270 + 75 + 130, 1e-9);
  EXPECT_NEAR(pose.linear().col(2).z(), 1, 1e-12);
}

TEST(Kinematics, ReadyIsTheNinetyDegreePoseWithTheToolDown) {
  const ToolPose pose = forward(model, model.ready);
  EXPECT_NEAR(pose.translation().x(), 100 + 270, 1e-9);
  EXPECT_NEAR(pose.translation().z(), 350 + 265 - 75 - 130, 1e-9);
  EXPECT_LT(angle_between_deg(pose, tool_down(0, 0, 0)), 1e-9);
}

TEST(Kinematics, PositiveTurnsGoTowardsYAndUp) {
  Joints turned = model.ready;
  turned[0] = 30;
  EXPECT_GT(forward(model, turned).translation().y(), 100);
  for (const std::size_t axis : {std::size_t{1}, std::size_t{2}, std::size_t{4}}) {
    Joints level{0, -45, -45, 0, 0, 0};
    const double before = forward(model, level).translation().z();
    level[axis] += 1;
    EXPECT_GT(forward(model, level).translation().z(), before) << "axis " << axis + 1;
  }
}

TEST(Kinematics, ToolDownFormulaHoldsForAnyArmPose) {
  Random random(seed);
  for (int i = 0; i < 1000; ++i) {
    Joints joints = random_joints(random);
    joints[3] = 0;
    joints[4] = -180 - joints[1] - joints[2];
    EXPECT_LT(angle_between_deg(forward(model, joints), tool_down(0, 0, 0, joints[0] + joints[5])), 1e-6)
        << "seed " << seed << " case " << i;
  }
}

TEST(Kinematics, FingersCloseAlongYWithTheToolDownAndTheWristTurnedBack) {
  const ToolPose pose = forward(model, {25, -40, -80, 0, -60, -25});
  EXPECT_NEAR(std::abs(pose.linear()(1, 1)), 1, 1e-12);
}

TEST(Kinematics, InverseKeepsTheBranchAndTheTurnsOfTheNearJoints) {
  Random random(seed);
  for (int i = 0; i < 5000; ++i) {
    const Joints joints = random_joints(random);
    if (std::abs(joints[4]) < 1 || std::abs(joints[2]) < 1) continue;
    const Result<Joints> same = inverse(model, forward(model, joints), joints);
    ASSERT_TRUE(same);
    for (std::size_t axis = 0; axis < model.axes.size(); ++axis) {
      EXPECT_NEAR((*same)[axis], joints[axis], 1e-6) << "seed " << seed << " case " << i << " axis " << axis + 1;
    }
  }
}

TEST(Kinematics, WorkspaceOfTheTableIsReachedWithTheToolDown) {
  for (double radius = 305; radius <= 580; radius += 5) {
    for (double height = 30; height <= 380; height += 10) {
      const Result<Joints> joints = inverse(model, tool_down(radius, 0, height), model.ready);
      ASSERT_TRUE(joints) << radius << " " << height << " " << joints.error().sentence;
      EXPECT_LT((*joints)[2], 0) << "the elbow stands above";
    }
  }
}

TEST(Kinematics, PosesOutOfReachAreRefused) {
  const std::pair<ToolPose, std::string> cases[] = {
      {tool_down(2000, 0, 100), "x leads"}, {tool_down(0, -900, 900), "y leads"}, {tool_down(450, 0, 3000), "z leads"}};
  for (const auto& [pose, coordinate] : cases) {
    const Result<Joints> joints = inverse(model, pose, model.ready);
    ASSERT_FALSE(joints);
    EXPECT_EQ(joints.error().symbol, "unreachable");
    EXPECT_NE(joints.error().sentence.find(coordinate), std::string::npos) << joints.error().sentence;
  }
}

TEST(Kinematics, PosesBeyondAnAxisLimitNameTheAxis) {
  // Close to the base and low, only axis 5 or 3 could fold further.
  const Result<Joints> joints = inverse(model, tool_down(150, 0, 30), model.ready);
  ASSERT_FALSE(joints);
  EXPECT_EQ(joints.error().symbol, "joint-limit");
  EXPECT_TRUE(joints.error().subject.is_integer());
}

TEST(Kinematics, SingularPosesKeepTheFreeAxisWhereItWas) {
  const Joints straight_wrist{10, -30, -60, 40, 0, 20};
  const Result<Joints> kept = inverse(model, forward(model, straight_wrist), straight_wrist);
  ASSERT_TRUE(kept);
  for (std::size_t axis = 0; axis < model.axes.size(); ++axis) EXPECT_NEAR((*kept)[axis], straight_wrist[axis], 1e-5);

  // The wrist centre on axis 1, tool straight up.
  ToolPose over_axis_1 = ToolPose::Identity();
  over_axis_1.translation() = Eigen::Vector3d(0, 0, 900);
  const Result<Joints> over = inverse(model, over_axis_1, {33, 0, -90, 0, 0, 0});
  ASSERT_TRUE(over) << over.error().sentence;
  EXPECT_NEAR((*over)[0], 33, 1e-6);
  EXPECT_LT((forward(model, *over).translation() - over_axis_1.translation()).norm(), 0.01);
}

TEST(Kinematics, StretchedArmIsSolvedAtTheVeryEdgeOfItsReach) {
  for (double j2 = -90; j2 <= 0; j2 += 7) {
    const Joints straight{5, j2, 0, 0, -60, 0};
    const Result<Joints> joints = inverse(model, forward(model, straight), straight);
    ASSERT_TRUE(joints);
    EXPECT_LT((forward(model, *joints).translation() - forward(model, straight).translation()).norm(), 0.01);
  }
}

TEST(Kinematics, PosesThatAreNotFiniteAreRefused) {
  ToolPose pose = tool_down(450, 0, 100);
  pose.translation().x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(inverse(model, pose, model.ready));
  pose.translation().x() = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(inverse(model, pose, model.ready));
}

TEST(Kinematics, LimitsAreThoseOfTheTableAndNameTheAxis) {
  constexpr std::array<double, 6> low{-180, -135, -135, -180, -135, -18432};
  constexpr std::array<double, 6> high{180, 45, 135, 180, 135, 18432};
  for (std::size_t axis = 0; axis < model.axes.size(); ++axis) {
    for (const double edge : {low[axis], high[axis]}) {
      Joints joints(6);
      joints[axis] = edge;
      EXPECT_TRUE(check_limits(model, joints));
      joints[axis] = edge + (edge < 0 ? -0.001 : 0.001);
      const Result<void> beyond = check_limits(model, joints);
      ASSERT_FALSE(beyond);
      EXPECT_EQ(beyond.error().symbol, "joint-limit");
      EXPECT_EQ(beyond.error().subject, to_datum(axis + 1));
    }
  }
  Joints broken(6);
  broken[2] = std::numeric_limits<double>::quiet_NaN();
  ASSERT_FALSE(check_limits(model, broken));
  EXPECT_EQ(check_limits(model, broken).error().symbol, "not-finite");
}

TEST(Kinematics, FixedAnglesTurnBackIntoTheirRotation) {
  Random random(seed);
  for (int i = 0; i < 1000; ++i) {
    const ToolPose pose = forward(model, random_joints(random));
    const auto [rx, ry, rz] = fixed_angles(pose.linear());
    ToolPose back = pose;
    const double unit = std::numbers::pi / 180;
    back.linear() = (Eigen::AngleAxisd(rz * unit, Eigen::Vector3d::UnitZ()) *
                     Eigen::AngleAxisd(ry * unit, Eigen::Vector3d::UnitY()) *
                     Eigen::AngleAxisd(rx * unit, Eigen::Vector3d::UnitX()))
                        .toRotationMatrix();
    EXPECT_LT(angle_between_deg(back, pose), 1e-6) << "seed " << seed << " case " << i;
  }
  const auto [rx, ry, rz] = fixed_angles(forward(model, {20, -40, -80, 0, -60, -15}).linear());
  EXPECT_NEAR(std::abs(rx), 180, 1e-9);
  EXPECT_NEAR(ry, 0, 1e-9);
  EXPECT_NEAR(rz, 5, 1e-9) << "with the tool down, rz is the sum of j1 and j6";
}

}  // namespace
}  // namespace pizarra::arm
