#include "drivers/arm/link_geometry.hpp"

#include <cmath>
#include <gtest/gtest.h>

#include "blackboard/time/random.hpp"
#include "drivers/arm/kinematics.hpp"

namespace pizarra {
namespace {

constexpr std::uint64_t seed = 7;
const ArmModel& model = crs_f3();

Joints random_links(Random& random) {
  const double j2 = random.uniform(-135, 45);
  const double j3 = random.uniform(-135, 135);
  return {random.uniform(-180, 180), j2, j3, 0, -180 - j2 - j3, 0};
}

// The wrist centre from axis 2 (d ahead, h above), by forward kinematics alone.
struct Wrist {
  double d_mm;
  double h_mm;
};
Wrist wrist_of(Joints joints) {
  joints[0] = 0;
  const ToolPose pose = forward(model, joints);
  const Eigen::Vector3d wrist = pose.translation() - (model.wrist_mm + model.tool_mm) * pose.linear().col(2);
  return {wrist.x() - model.base_offset_mm, wrist.z() - model.base_height_mm};
}

// Links moved by the formulas; the end-effector axis takes back what axes 2 and 3 turned.
std::optional<Joints> moved(const Joints& joints, const LinkGeometry& links) {
  const std::optional<LinkJoints> to = link_joints(model, links);
  if (!to) return std::nullopt;
  Joints out = joints;
  out[1] = to->j2_deg;
  out[2] = to->j3_deg;
  out[4] -= (out[1] - joints[1]) + (out[2] - joints[2]);
  return out;
}

TEST(LinkGeometry, AgreesWithForwardKinematicsAndLeadsBack) {
  Random random(seed);
  for (int i = 0; i < 2000; ++i) {
    const Joints joints = random_links(random);
    const LinkGeometry links = link_geometry(model, joints);
    const Wrist wrist = wrist_of(joints);
    EXPECT_NEAR(links.d_mm, wrist.d_mm, 1e-6) << "seed " << seed << " case " << i;
    EXPECT_NEAR(links.h_mm, wrist.h_mm, 1e-6);
    EXPECT_NEAR(links.c_mm, std::hypot(wrist.d_mm, wrist.h_mm), 1e-6);
    const std::optional<LinkJoints> back = link_joints(model, links);
    ASSERT_TRUE(back);
    EXPECT_NEAR(std::remainder(back->j2_deg - joints[1], 360), 0, 1e-4) << "seed " << seed << " case " << i;
    EXPECT_NEAR(back->j3_deg, joints[2], 1e-4);
  }
}

TEST(LinkGeometry, ExtendingKeepsHeightDistanceOrAngleAndTheToolPose) {
  Random random(seed);
  int checked = 0;
  for (int i = 0; i < 2000; ++i) {
    const Joints joints = random_links(random);
    const double by = random.uniform(-40, 40);
    const LinkGeometry before = link_geometry(model, joints);
    for (const int option : {0, 1, 2}) {
      LinkGeometry links = before;
      if (option == 0) links.d_mm += by;
      if (option == 1) links.h_mm += by;
      if (option == 2) links.d_mm *= (before.c_mm + by) / before.c_mm;
      if (option == 2) links.h_mm *= (before.c_mm + by) / before.c_mm;
      const std::optional<Joints> joints_after = moved(joints, links);
      if (!joints_after) continue;
      ++checked;
      const LinkGeometry after = link_geometry(model, *joints_after);
      const Wrist wrist = wrist_of(*joints_after);
      const double kept_before[] = {before.h_mm, before.d_mm, before.alpha_deg};
      const double kept_after[] = {wrist.h_mm, wrist.d_mm, after.alpha_deg};
      EXPECT_NEAR(std::remainder(kept_after[option] - kept_before[option], 360), 0, 1e-6)
          << "seed " << seed << " case " << i;
      const ToolPose a = forward(model, joints);
      const ToolPose b = forward(model, *joints_after);
      EXPECT_LT((a.linear() - b.linear()).norm(), 1e-9) << "dj5 = -(dj2 + dj3) keeps the tool's direction";
      EXPECT_NEAR((a.translation() - b.translation()).norm(), std::abs(by), 1e-6) << "the tool goes with the wrist";
    }
  }
  EXPECT_GT(checked, 3000);
}

TEST(LinkGeometry, BeyondTheLinksThereIsNothing) {
  const double full = model.upper_arm_mm + model.forearm_mm;
  EXPECT_FALSE(link_joints(model, {0, full + 0.001, full, 0, true}));
  EXPECT_FALSE(link_joints(model, {0, 1, 1, 0, true}));
  EXPECT_TRUE(link_joints(model, {0, full, full, 0, true}));
}

}  // namespace
}  // namespace pizarra
