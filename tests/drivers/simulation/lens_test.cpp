// Lenses that bend the images of the simulated cameras.

#include <gtest/gtest.h>
#include <opencv2/calib3d.hpp>

#include "drivers/simulation/camera_lens.hpp"
#include "drivers/simulation/render/stereo_renderer.hpp"
#include "tests/drivers/simulation/bench.hpp"

namespace pizarra::simulation {
namespace {

using Eigen::Vector3d;

constexpr LensDistortion barrel{-0.3, 0.08, 0.001, -0.002, 0.01};

WorldConfig quiet_world(const LensDistortion& lens) {
  WorldConfig config = four_cubes();
  config.camera.noise_sigma = 0;
  config.camera.light_gradient = 0;
  config.camera.lens = lens;
  return config;
}

// The middle of what is dark around a place.
cv::Point2d dark_around(const Image& image, const cv::Point2d& place) {
  constexpr int near_px = 13;
  cv::Point2d sum;
  double weights = 0;
  for (int y = cvRound(place.y) - near_px; y <= cvRound(place.y) + near_px; ++y) {
    for (int x = cvRound(place.x) - near_px; x <= cvRound(place.x) + near_px; ++x) {
      const auto row = static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width);
      const double weight = std::max(0, 100 - image.pixels[row + static_cast<std::size_t>(x)]);
      sum += weight * cv::Point2d(x, y);
      weights += weight;
    }
  }
  return sum / weights;
}

// As OpenCV, which shares nothing with the renderer, projects a point.
cv::Point2d seen_by_opencv(const CameraConfig& camera, Side side, const Vector3d& point) {
  const Eye eye = make_eye(camera, side);
  const Vector3d seen = eye.axes * (point - eye.position_mm);
  const cv::Matx33d pinhole(eye.focal_px, 0, eye.centre_x_px, 0, eye.focal_px, eye.centre_y_px, 0, 0, 1);
  std::vector<cv::Point2d> out;
  cv::projectPoints(std::vector{cv::Point3d(seen.x(), seen.y(), seen.z())}, cv::Vec3d(), cv::Vec3d(), pinhole,
                    cv::Vec<double, 5>(camera.lens.data()), out);
  return out.front();
}

TEST(Lens, ShowsMarksWhereOpenCvProjectsThem) {
  const WorldConfig config = quiet_world(barrel);
  Snapshot snapshot;
  snapshot.joints = {60, 0, -90, 0, -90, 0};
  for (const double y : {-190.0, 0.0, 190.0}) {
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.translation() = Vector3d(450, y, 30);
    snapshot.cubes.push_back({pose, on_each_face(Mark::circle), true, cube_shape(60)});
  }
  StereoRenderer renderer(config, Random(1));
  const StereoPair pair = renderer.render(snapshot, config.camera, 1, false);
  for (const Snapshot::Cube& cube : snapshot.cubes) {
    const Vector3d mark = cube.pose.translation() + Vector3d(30, 0, 0);
    for (const Side side : {Side::left, Side::right}) {
      const cv::Point2d expected = seen_by_opencv(config.camera, side, mark);
      const cv::Point2d seen = dark_around(side == Side::left ? *pair.left : *pair.right, expected);
      EXPECT_LT(cv::norm(seen - expected), 0.15) << mark.transpose();
    }
  }
}

TEST(Lens, OfTheImagesIsTakenOutByTheCalibrationThatTheCamerasGive) {
  Bench bench(quiet_world(barrel));
  const Result<camera::StereoModel> model = run(bench.executor, bench.eyes.open());
  ASSERT_TRUE(model) << describe(model.error());
  EXPECT_NE(model->focal_px, bench.config.camera.model.focal_px);
  EXPECT_NEAR(model->base_line_mm, 90, 1e-9);
  CameraConfig straight = bench.config.camera;
  straight.model = *model;
  straight.lens = {};
  const camera::StereoFrame frame = bench.frame();
  const TruthOf circle = bench.truth("circle");
  for (const Side side : {Side::left, Side::right}) {
    const cv::Point2d expected = seen_by_opencv(straight, side, {circle.x_mm + 30, circle.y_mm, circle.z_mm});
    const cv::Point2d seen = dark_around(side == Side::left ? *frame.left : *frame.right, expected);
    EXPECT_LT(cv::norm(seen - expected), 0.2);
  }
}

TEST(Lens, OfTheTruthIsThatOfStraightImages) {
  Bench bench(quiet_world({-0.3, 0, 0, 0, 0}));
  const Result<camera::StereoModel> model = run(bench.executor, bench.eyes.open());
  ASSERT_TRUE(model) << describe(model.error());
  CameraConfig straight = bench.config.camera;
  straight.model = *model;
  const TruthOf circle = bench.truth("circle");
  const Vector3d expected = make_eye(straight, Side::left).project({circle.x_mm + 30, circle.y_mm, circle.z_mm});
  const Datum seen = bench.ask("(where-seen circle)");
  EXPECT_NEAR(seen[0].number(), expected.x(), 0.5);
  EXPECT_NEAR(seen[1].number(), expected.y(), 0.5);
}

TEST(Lens, IsUndoneExactly) {
  for (const LensDistortion& lens : {barrel, LensDistortion{0.3, 0, 0, 0, 0}, LensDistortion{}}) {
    for (const double x : {-0.37, 0.0, 0.2}) {
      for (const double y : {-0.27, 0.0, 0.15}) {
        const std::optional<Eigen::Vector2d> straight = undistorted(lens, {x, y});
        ASSERT_TRUE(straight);
        std::vector<cv::Point2d> again;
        cv::projectPoints(std::vector{cv::Point3d(straight->x(), straight->y(), 1)}, cv::Vec3d(), cv::Vec3d(),
                          cv::Matx33d::eye(), cv::Vec<double, 5>(lens.data()), again);
        EXPECT_NEAR(again.front().x, x, 1e-9);
        EXPECT_NEAR(again.front().y, y, 1e-9);
      }
    }
  }
}

TEST(Lens, ThatFoldsTheImageIsRefused) {
  EXPECT_TRUE(check(quiet_world(barrel)));
  EXPECT_TRUE(check(quiet_world({0.4, 0, 0, 0, 0})));
  for (const LensDistortion& lens : {LensDistortion{-0.9, 0, 0, 0, 0}, LensDistortion{-1, -1, 0, 0, -1}}) {
    const Result<void> folded = check(quiet_world(lens));
    ASSERT_FALSE(folded);
    EXPECT_EQ(folded.error().symbol, "bad-cell");
  }
}

}  // namespace
}  // namespace pizarra::simulation
