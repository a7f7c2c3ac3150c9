// How a mark's plane lies by both images of a pair, from edges that are projected from known poses.

#include <cmath>
#include <gtest/gtest.h>

#include "agents/vision/sight/plane_pose.hpp"
#include "tests/agents/vision/drawn_planes.hpp"

namespace pizarra::vision {
namespace {

// As a camera so far to the right of the left one shows it, its edges found to 0.15 px.
PlaneFit fit_of(const camera::StereoModel& model, const LearnedSample& sample, const cv::Matx33d& turn,
                const cv::Vec3d& place, double beside_mm, Random& random) {
  const double unit_mm = sample.face_mm();
  const cv::Vec2d middle = sample.plane.middle;
  const cv::Matx33d lens(model.focal_px, 0, model.centre_x_px, 0, model.focal_px, model.centre_y_px, 0, 0, 1);
  const cv::Matx33d in_plane(unit_mm, 0, -unit_mm * middle[0], 0, unit_mm, -unit_mm * middle[1], 0, 0, 1);
  cv::Matx33d axes = turn;
  for (int i = 0; i < 3; ++i) axes(i, 2) = place[i] - (i == 0 ? beside_mm : 0);
  PlaneFit out{.to_image = lens * axes * in_plane, .edges = {}, .rms_px = 0.15, .supported = 1};
  for (std::size_t i = 0; i < sample.plane.points.size(); ++i) {
    const PlaneOutline::Point& point = sample.plane.points[i];
    const cv::Vec2d normal = cv::normalize(out.slope_at(point.at).inv().t() * point.out);
    const double off_px = 0.15 * random.normal();
    const cv::Point2d at = out.in_image(point.at) + off_px * cv::Point2d(normal);
    out.edges.push_back({.found = true,
                         .point = i,
                         .at = at,
                         .normal = normal,
                         .off_px = off_px,
                         .is_border = true,
                         .counts = true,
                         .measures = true,
                         .is_straight = true});
  }
  return out;
}

// From where the left image alone begins, the solution may end beside that by both.
TEST(Plane, ByAPairIsNeverAnotherThanTheOneThatBothImagesShow) {
  Random random(17);
  camera::StereoModel pair = one_camera();
  pair.base_line_mm = 80;
  for (const Corners& shape : {circle(), cross, square, Corners{{-21, 12}, {21, 12}, {0, -24}}}) {
    const LearnedSample sample = learned(shape, random);
    for (int i = 0; i < 2000; ++i) {
      const double towards = random.uniform(0, 2 * CV_PI);
      const double tilt = random.uniform(20, 55) * CV_PI / 180;
      const cv::Matx33d turn = turned_about({tilt * std::cos(towards), tilt * std::sin(towards), 0}) *
                               turned_about({0, 0, random.uniform(-CV_PI, CV_PI)});
      const cv::Vec3d place(random.uniform(-150, 150), random.uniform(-100, 100), random.uniform(420, 700));
      const PlaneFit left = fit_of(pair, sample, turn, place, 0, random);
      const PlaneFit right = fit_of(pair, sample, turn, place, pair.base_line_mm, random);
      const std::optional<PlanePose> pose = plane_pose(pair, sample.plane, left, {sample.face_mm()}, &right);
      ASSERT_TRUE(pose);
      ASSERT_LT(degrees_between(pose->turn, turn), 8) << i;
    }
  }
}

}  // namespace
}  // namespace pizarra::vision
