#include "drivers/ptu/head_axes.hpp"

#include <gtest/gtest.h>

#include "blackboard/time/random.hpp"

namespace pizarra::ptu {
namespace {

TEST(HeadAxes, WhereNothingIsKnownOfThemTheAnglesAddToHowTheCameraLooks) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    Random random(seed);
    const HeadTurn turn{random.uniform(-60, 60), random.uniform(-40, 30)};
    forms::CameraPose pose{{1330, -20, 200}, random.uniform(-60, 60), random.uniform(-40, 40), random.uniform(-45, 45)};
    const Eigen::Isometry3d turned = camera_frame(pose) * head_turn(pose, turn);
    pose.pan_deg += turn.pan_deg;
    pose.tilt_deg += turn.tilt_deg;
    EXPECT_TRUE(turned.isApprox(camera_frame(pose), 1e-9)) << "seed " << seed;
  }
}

TEST(HeadAxes, PanTakesACameraBeforeItsAxisAroundItToTheRight) {
  forms::CameraPose pose;
  pose.axes = {.pan = {{0, 0, -100}, {0, 1, 0}}, .tilt = {{0, 0, 0}, {1, 0, 0}}};
  const Eigen::Isometry3d turned = head_turn(pose, {.pan_deg = 90, .tilt_deg = 0});
  EXPECT_TRUE(turned.translation().isApprox(Eigen::Vector3d(100, 0, -100), 1e-9));
  EXPECT_TRUE((turned.linear() * Eigen::Vector3d::UnitZ()).isApprox(Eigen::Vector3d::UnitX(), 1e-9));
}

TEST(HeadAxes, PanTakesTheTiltAxisAlong) {
  forms::CameraPose pose;
  pose.axes = {.pan = {{0, 0, 0}, {0, 1, 0}}, .tilt = {{0, 50, 0}, {1, 0, 0}}};
  const Eigen::Isometry3d turned = head_turn(pose, {.pan_deg = 90, .tilt_deg = 90});
  // Panned to the right, then up: the camera above the tilt axis has gone backwards, that is to the left.
  EXPECT_TRUE(turned.translation().isApprox(Eigen::Vector3d(-50, 50, 0), 1e-9));
  EXPECT_TRUE((turned.linear() * Eigen::Vector3d::UnitZ()).isApprox(-Eigen::Vector3d::UnitY(), 1e-9));
}

}  // namespace
}  // namespace pizarra::ptu
