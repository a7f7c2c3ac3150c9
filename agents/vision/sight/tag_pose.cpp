#include "agents/vision/sight/tag_pose.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "agents/vision/sight/plane_solve.hpp"

namespace pizarra::vision {
namespace {

// Of a corner along x, and along y: a standard deviation, measured of tags in any light, noise and blur.
constexpr double corner_spread_px = 0.15;
// Farther from where the pose puts them no corners of a square are, as a part of its side.
constexpr double most_off_share = 0.05;

// Each corner along x and along y; the plane's x right and y down, its zero the middle of the square.
std::vector<PlanePoint> points_of(const camera::StereoModel& model, const std::array<cv::Point2f, 4>& corners,
                                  const std::array<cv::Point2f, 4>& square) {
  std::vector<PlanePoint> out;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Eigen::Vector2d plane(square[i].x, square[i].y);
    const Eigen::Vector2d seen((corners[i].x - model.centre_x_px) / model.focal_px,
                               (corners[i].y - model.centre_y_px) / model.focal_px);
    out.push_back({plane, seen, {model.focal_px, 0}});
    out.push_back({plane, seen, {0, model.focal_px}});
  }
  return out;
}

}  // namespace

std::optional<TagPose> tag_pose(const camera::StereoModel& model, const std::array<cv::Point2f, 4>& corners,
                                double side_mm) {
  const auto half = static_cast<float>(side_mm / 2);
  const std::array<cv::Point2f, 4> square = {{{-half, -half}, {half, -half}, {half, half}, {-half, half}}};
  const std::vector<PlanePoint> points = points_of(model, corners, square);
  const cv::Matx33d look = cv::getPerspectiveTransform(square.data(), corners.data());
  const cv::Point2d centre(look(0, 2), look(1, 2));
  const cv::Matx22d slope(look(0, 0) - look(2, 0) * centre.x, look(0, 1) - look(2, 1) * centre.x,
                          look(1, 0) - look(2, 0) * centre.y, look(1, 1) - look(2, 1) * centre.y);
  const std::vector<SolvedPlane> both =
      solve_plane(points, plane_guesses(model, centre, slope), {.weight = 1 / (corner_spread_px * corner_spread_px)});
  if (both.empty()) return std::nullopt;
  const PlaneGuess& pose = both.front().pose;
  const double side_px = cv::arcLength(std::vector<cv::Point2f>(corners.begin(), corners.end()), true) / 4;
  const bool fits = std::ranges::all_of(
      points, [&](const PlanePoint& point) { return std::abs(off_px(point, pose)) < most_off_share * side_px; });
  if (!fits) return std::nullopt;
  const cv::Vec3d middle(pose.place.x(), pose.place.y(), pose.place.z());
  const cv::Vec3d from_base = middle - cv::Vec3d(model.base_line_mm / 2, 0, 0);
  const double range = cv::norm(from_base);
  const Eigen::Matrix<double, 6, 6> covariance = both.front().covariance;
  const Eigen::Vector3d sight = Eigen::Vector3d(from_base[0], from_base[1], from_base[2]) / range;
  const double variance = sight.dot(covariance.topLeftCorner<3, 3>() * sight);
  return TagPose{middle, matx_of(pose.turn), range, std::sqrt(variance), covariance};
}

}  // namespace pizarra::vision
