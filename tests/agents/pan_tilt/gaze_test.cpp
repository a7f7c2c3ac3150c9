#include "agents/pan_tilt/gaze.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "blackboard/time/random.hpp"
#include "drivers/ptu/head_axes.hpp"

namespace pizarra::pan_tilt {
namespace {

TEST(Gaze, LooksStraightAheadAtWhatIsStraightAhead) {
  const Gaze gaze = gaze_at(forms::CameraPose{}, {450, 0, 200});
  EXPECT_NEAR(gaze.pan_deg, 0, 1e-9);
  EXPECT_NEAR(gaze.tilt_deg, 0, 1e-9);
}

TEST(Gaze, PansToTheRightOfTheImageAndTiltsUp) {
  const Gaze gaze = gaze_at(forms::CameraPose{}, {1330 - 500, 500, 700});
  EXPECT_NEAR(gaze.pan_deg, 45, 1e-9);
  EXPECT_NEAR(gaze.tilt_deg, std::atan2(500, std::hypot(500, 500)) * 180 / std::numbers::pi, 1e-9);
}

TEST(Gaze, ThePointLiesOnTheAxisOfACameraTurnedThatWay) {
  for (std::uint64_t seed = 1; seed <= 500; ++seed) {
    Random random(seed);
    const forms::CameraPose mount{
        {1330, random.uniform(-100, 100), 200}, random.uniform(-30, 30), random.uniform(-20, 20)};
    const std::array<double, 3> point{random.uniform(300, 600), random.uniform(-300, 300), random.uniform(0, 400)};
    const Gaze gaze = gaze_at(mount, point);
    const double pan = (mount.pan_deg + gaze.pan_deg) * std::numbers::pi / 180;
    const double tilt = (mount.tilt_deg + gaze.tilt_deg) * std::numbers::pi / 180;
    const double away = std::hypot(point[0] - mount.at_mm[0], point[1] - mount.at_mm[1], point[2] - mount.at_mm[2]);
    EXPECT_NEAR(mount.at_mm[0] - away * std::cos(tilt) * std::cos(pan), point[0], 1e-6) << "seed " << seed;
    EXPECT_NEAR(mount.at_mm[1] + away * std::cos(tilt) * std::sin(pan), point[1], 1e-6) << "seed " << seed;
    EXPECT_NEAR(mount.at_mm[2] + away * std::sin(tilt), point[2], 1e-6) << "seed " << seed;
  }
}

TEST(Gaze, ThePointIsInTheMiddleOfACameraWhoseHeadTurnsAboutAxesBesideIt) {
  forms::CameraPose mount{{1330, 10, 200}, 2, -4, 1};
  mount.axes = {.pan = {{7, 0, -41}, {0.03, 1, -0.02}}, .tilt = {{0, 54, -33}, {1, -0.015, 0.025}}};
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    Random random(seed);
    const Eigen::Vector3d point(random.uniform(300, 600), random.uniform(-300, 300), random.uniform(0, 400));
    const Gaze gaze = gaze_at(mount, {point.x(), point.y(), point.z()});
    const Eigen::Isometry3d stands =
        ptu::camera_frame(mount) * ptu::head_turn(mount, {.pan_deg = gaze.pan_deg, .tilt_deg = gaze.tilt_deg});
    const Eigen::Vector3d seen = stands.inverse() * point;
    EXPECT_NEAR(seen.x(), 0, 1e-6) << "seed " << seed;
    EXPECT_NEAR(seen.y(), 0, 1e-6) << "seed " << seed;
    EXPECT_GT(seen.z(), 0) << "seed " << seed;
  }
}

}  // namespace
}  // namespace pizarra::pan_tilt
