// A second lamp, and its shadows.

#include <gtest/gtest.h>

#include "drivers/simulation/render/second_lamp.hpp"
#include "drivers/simulation/render/stereo_renderer.hpp"

namespace pizarra::simulation {
namespace {

using Eigen::Vector3d;

const LampConfig lamp{.at_mm = {1200, 800, 1000}, .part = 0.5};
const Vector3d face(480, 0, 30);  // of the cube in the row, turned to the camera
const Vector3d on_face(480, 24, 54);
const Vector3d lamp_mm(lamp.at_mm[0], lamp.at_mm[1], lamp.at_mm[2]);

WorldConfig quiet_world(bool with_lamp) {
  WorldConfig config;
  config.camera.noise_sigma = 0;
  config.camera.light_gradient = 0;
  if (with_lamp) config.second_lamp = lamp;
  return config;
}

Snapshot::Cube cube_at(const Vector3d& place) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() = place;
  return {pose, on_each_face(Mark::circle), true, cube_shape(60)};
}

// A cube in the row, and another one in the air where it is in the way of the light to a point.
Snapshot with_shade_on(const Vector3d& point) {
  Snapshot snapshot;
  snapshot.joints = {60, 0, -90, 0, -90, 0};
  snapshot.cubes = {cube_at({450, 0, 30}), cube_at(point + 0.25 * (lamp_mm - point))};
  return snapshot;
}

double level(const WorldConfig& config, const Snapshot& snapshot, const Vector3d& point) {
  StereoRenderer renderer(config, Random(1));
  const StereoPair pair = renderer.render(snapshot, config.camera, 1, false);
  const Vector3d at = make_eye(config.camera, Side::left).project(point);
  const auto index = std::lround(at.y()) * pair.left->width + std::lround(at.x());
  return pair.left->pixels[static_cast<std::size_t>(index)];
}

// What a shadow leaves of the light there.
double left_over(bool with_lamp, const Vector3d& shaded, const Vector3d& point) {
  const Snapshot shade = with_shade_on(shaded);
  Snapshot none = shade;
  none.cubes.pop_back();
  const WorldConfig config = quiet_world(with_lamp);
  return level(config, shade, point) / level(config, none, point);
}

TEST(SecondLamp, IsTakenFromAFaceThatAnotherCubeKeepsItFrom) {
  const double dark = part_in_shadow(lamp, face, Vector3d::UnitX());
  EXPECT_GT(dark, 0.2);
  EXPECT_NEAR(left_over(true, face, on_face), 1 - dark, 0.02);
  EXPECT_NEAR(left_over(false, face, on_face), 1, 0.01);
}

TEST(SecondLamp, ThrowsAShadowOnTheTable) {
  const Vector3d on_table(560, -120, 0);
  const double dark = part_in_shadow(lamp, on_table, Vector3d::UnitZ());
  EXPECT_GT(dark, 0.2);
  EXPECT_NEAR(left_over(true, on_table, on_table), 1 - dark, 0.03);
  EXPECT_NEAR(left_over(false, on_table, on_table), 1, 0.01);
}

TEST(SecondLamp, HasSharpShadows) {
  // Its edge stands upright across the lower end of the face; three pixels further all is light, or all dark.
  const Vector3d aside = face + Vector3d(0, 90, 0);
  const double dark = part_in_shadow(lamp, face, Vector3d::UnitX());
  EXPECT_NEAR(left_over(true, aside, {480, 12, 4}), 1 - dark, 0.03);
  EXPECT_NEAR(left_over(true, aside, {480, 0, 4}), 1, 0.03);
}

TEST(SecondLamp, LeavesAFaceThatIsTurnedAwayWithoutItsLightAndShadow) {
  EXPECT_EQ(part_in_shadow(lamp, face, -Vector3d::UnitX()), 0);
  EXPECT_EQ(part_in_shadow({.at_mm = lamp.at_mm, .part = 0}, face, Vector3d::UnitX()), 0);
}

}  // namespace
}  // namespace pizarra::simulation
