// Photographs behind the table and on it.

#include <gtest/gtest.h>

#include "drivers/simulation/render/seen_photograph.hpp"
#include "drivers/simulation/render/stereo_renderer.hpp"
#include "lisp/numbers.hpp"

namespace pizarra::simulation {
namespace {

using Eigen::Vector3d;

constexpr std::size_t wide = 160;
constexpr std::size_t high = 120;

// Light, with a dark square whose upper left corner is there.
std::shared_ptr<const Photograph> with_square(std::size_t left, std::size_t top, std::size_t side) {
  Image image{static_cast<int>(wide), static_cast<int>(high), 3, std::vector<std::uint8_t>(wide * high * 3, 220)};
  for (std::size_t y = top; y < top + side; ++y) {
    for (std::size_t i = left * 3; i < (left + side) * 3; ++i) image.pixels[y * wide * 3 + i] = 20;
  }
  return std::make_shared<const Photograph>(std::move(image));
}

WorldConfig still_world() {
  WorldConfig config;
  config.camera.noise_sigma = 0;
  config.camera.light_gradient = 0;
  return config;
}

Snapshot arm_aside() {
  Snapshot snapshot;
  snapshot.joints = {60, 0, -90, 0, -90, 0};
  return snapshot;
}

// The middle of what is dark around a place.
Eigen::Vector2d dark_middle(const Image& image, const Vector3d& place, int reach) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  double weights = 0;
  const auto x0 = static_cast<int>(std::lround(place.x()));
  const auto y0 = static_cast<int>(std::lround(place.y()));
  for (int y = y0 - reach; y <= y0 + reach; ++y) {
    for (int x = x0 - reach; x <= x0 + reach; ++x) {
      const auto row = static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width);
      const double weight = std::max(0, 150 - image.pixels[row + static_cast<std::size_t>(x)]);
      sum += weight * Eigen::Vector2d(x, y);
      weights += weight;
    }
  }
  return sum / weights;
}

// Where the square's middle lies in the base frame.
Vector3d middle_of(const LaidPhotograph& laid, double left, double top, double side) {
  return laid.corner_mm + laid.right_mm * (left + side / 2) + laid.down_mm * (top + side / 2);
}

void expect_true_in_both_images(const WorldConfig& config, const Vector3d& middle, int reach) {
  StereoRenderer renderer(config, Random(1));
  const StereoPair pair = renderer.render(arm_aside(), config.camera, 1, false);
  for (const Side side : {Side::left, Side::right}) {
    const Vector3d expected = make_eye(config.camera, side).project(middle);
    const Eigen::Vector2d seen = dark_middle(side == Side::left ? *pair.left : *pair.right, expected, reach);
    EXPECT_NEAR(seen.x(), expected.x(), 0.15);
    EXPECT_NEAR(seen.y(), expected.y(), 0.3);
  }
}

TEST(Photograph, BehindTheTableIsSeenAtItsDepthByBothCameras) {
  WorldConfig config = still_world();
  config.background = with_square(40, 20, 10);
  const Vector3d middle = middle_of(behind_the_table(config), 40, 20, 10);
  EXPECT_LT(middle.x(), config.table.x_low_mm);
  expect_true_in_both_images(config, middle, 16);
}

TEST(Photograph, OnTheTableIsSeenInPerspective) {
  WorldConfig config = still_world();
  config.table_picture = with_square(46, 95, 4);
  expect_true_in_both_images(config, middle_of(over_the_table(config), 46, 95, 4), 12);
}

TEST(Photograph, BehindTheTableIsSeenElsewhereByACameraThatTurns) {
  WorldConfig config = still_world();
  config.background = with_square(30, 20, 10);
  const Vector3d middle = middle_of(behind_the_table(config), 30, 20, 10);
  config.camera.head = "ptu46-17.5";
  CameraConfig turned = config.camera;
  turned.turn = {.pan_deg = 4, .tilt_deg = 2};
  StereoRenderer renderer(config, Random(1));
  const StereoPair pair = renderer.render(arm_aside(), turned, 1, false);
  const Vector3d expected = make_eye(turned, Side::left).project(middle);
  const Vector3d before = make_eye(config.camera, Side::left).project(middle);
  EXPECT_GT((expected - before).head<2>().norm(), 10);
  EXPECT_LT((dark_middle(*pair.left, expected, 16) - expected.head<2>()).norm(), 0.3);
}

TEST(Photograph, FillsTheImagesOfACameraThatLooksDown) {
  WorldConfig config = still_world();
  config.camera.pose.at_mm[2] = 700;
  config.camera.pose.tilt_deg = -30;
  config.camera.pose.roll_deg = 20;
  config.background = std::make_shared<const Photograph>(Image{1, 1, 3, {10, 10, 10}});
  config.table_picture = config.background;
  StereoRenderer renderer(config, Random(1));
  Snapshot none = arm_aside();
  none.joints = {180, 0, 0, 0, 0, 0};
  const StereoPair pair = renderer.render(none, config.camera, 1, false);
  for (const int corner : {0, 319, 320 * 239, 320 * 240 - 1}) {
    EXPECT_LE(pair.left->pixels[static_cast<std::size_t>(corner)], 11) << corner;
    EXPECT_LE(pair.right->pixels[static_cast<std::size_t>(corner)], 11) << corner;
  }
}

TEST(Photograph, GoesOnMirroredBeyondItsBorders) {
  const auto photograph = with_square(0, 0, 20);
  EXPECT_NEAR(photograph->at(10, 10, 1).x(), 20, 1);
  EXPECT_NEAR(photograph->at(-10, 10, 1).x(), 20, 1);
  EXPECT_NEAR(photograph->at(-10, -10, 1).x(), 20, 1);
  EXPECT_NEAR(photograph->at(-30, 10, 1).x(), 220, 1);
  EXPECT_NEAR(photograph->at(2 * wide + 10, 2 * high - 10, 1).x(), 20, 1);
}

TEST(Photograph, IsTheMeanOfWhatAPixelShowsOfIt) {
  Image stripes{64, 64, 3, {}};
  for (int i = 0; i < 64 * 64; ++i) stripes.pixels.insert(stripes.pixels.end(), 3, i % 2 == 0 ? 0 : 200);
  const Photograph photograph(std::move(stripes));
  EXPECT_NEAR(photograph.at(30.5, 30.5, 1).y(), 0, 1);
  EXPECT_NEAR(photograph.at(30.5, 30.5, 4).y(), 100, 2);
  EXPECT_NEAR(photograph.at(30.5, 30.5, 1e9).y(), 100, 2);
}

TEST(Photograph, OnTheTableIsDarkerInAHardShadow) {
  WorldConfig config = still_world();
  config.table_picture = std::make_shared<const Photograph>(Image{1, 1, 3, {200, 200, 200}});
  config.second_lamp = LampConfig{.at_mm = {1200, 800, 1000}, .part = 0.5};
  Snapshot snapshot = arm_aside();
  const Vector3d point(560, -120, 0);
  Eigen::Isometry3d in_the_way = Eigen::Isometry3d::Identity();
  in_the_way.translation() = point + 0.25 * (Vector3d(1200, 800, 1000) - point);
  const auto level = [&](const Snapshot& world) {
    StereoRenderer renderer(config, Random(1));
    const StereoPair pair = renderer.render(world, config.camera, 1, false);
    const Vector3d at = make_eye(config.camera, Side::left).project(point);
    return static_cast<int>(
        pair.left->pixels[static_cast<std::size_t>(std::lround(at.y()) * pair.left->width + std::lround(at.x()))]);
  };
  const int lit = level(snapshot);
  snapshot.cubes = {{in_the_way, on_each_face(Mark::circle), true, cube_shape(60)}};
  EXPECT_LT(level(snapshot), 0.8 * lit);
}

}  // namespace
}  // namespace pizarra::simulation
