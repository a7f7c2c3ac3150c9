#include "agents/vision/sight/tag_pose.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "agents/vision/sight/plane_solve.hpp"

namespace pizarra::vision {
namespace {

// Of a corner along x, and along y: a standard deviation, measured of tags in any light, noise and blur.
constexpr double corner_spread_px = 0.15;
// Farther from where the pose puts them no corners of a square are, as a part of its side.
constexpr double most_off_share = 0.05;

// How far a learned side may be off where a pair measures the pose, as a part of it.
constexpr double side_spread = 0.01;

SquareCorners square_of(double side_mm) {
  const auto half = static_cast<float>(side_mm / 2);
  return {{{-half, -half}, {half, -half}, {half, half}, {-half, half}}};
}

// Each corner along x and along y; the plane's x right and y down, its zero the middle of the square.
void add_points(std::vector<PlanePoint>& out, const camera::StereoModel& model, const SquareCorners& corners,
                const SquareCorners& square, double beside_mm) {
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Eigen::Vector2d plane(square[i].x, square[i].y);
    const Eigen::Vector2d seen((corners[i].x - model.centre_x_px) / model.focal_px,
                               (corners[i].y - model.centre_y_px) / model.focal_px);
    out.push_back({plane, seen, {model.focal_px, 0}, beside_mm});
    out.push_back({plane, seen, {0, model.focal_px}, beside_mm});
  }
}

std::vector<PlaneGuess> guesses_by(const camera::StereoModel& model, const SquareCorners& corners,
                                   const SquareCorners& square) {
  const cv::Matx33d look = cv::getPerspectiveTransform(square.data(), corners.data());
  const cv::Point2d centre(look(0, 2), look(1, 2));
  const cv::Matx22d slope(look(0, 0) - look(2, 0) * centre.x, look(0, 1) - look(2, 1) * centre.x,
                          look(1, 0) - look(2, 0) * centre.y, look(1, 1) - look(2, 1) * centre.y);
  return plane_guesses(model, centre, slope);
}

}  // namespace

std::optional<TagPose> tag_pose(const camera::StereoModel& model, const SquareCorners& left, double side_mm,
                                const SquareCorners* right) {
  const SquareCorners square = square_of(side_mm);
  std::vector<PlanePoint> points;
  add_points(points, model, left, square, 0);
  if (right != nullptr) add_points(points, model, *right, square, model.base_line_mm);
  PlaneErrors errors{.weight = 1 / (corner_spread_px * corner_spread_px)};
  if (right != nullptr) errors.size_spread = side_spread;
  const std::vector<SolvedPlane> both = solve_plane(points, guesses_by(model, left, square), errors);
  if (both.empty()) return std::nullopt;
  const PlaneGuess& pose = both.front().pose;
  const double side_px = cv::arcLength(std::vector<cv::Point2f>(left.begin(), left.end()), true) / 4;
  const bool fits = std::ranges::all_of(
      points, [&](const PlanePoint& point) { return std::abs(off_px(point, pose)) < most_off_share * side_px; });
  if (!fits) return std::nullopt;
  const SolvedPlane& other = both.back();
  const double worse = std::min(other.misfit - both.front().misfit, 50.0);
  const double share = both.size() > 1 ? 1 / (1 + std::exp(worse)) : 0;
  // The middle is elsewhere then.
  const Eigen::Vector3d apart = other.pose.place - pose.place;
  Eigen::Matrix<double, 6, 6> covariance = both.front().covariance;
  covariance.topLeftCorner<3, 3>() += share * apart * apart.transpose();
  const cv::Vec3d middle(pose.place.x(), pose.place.y(), pose.place.z());
  const cv::Vec3d from_base = middle - cv::Vec3d(model.base_line_mm / 2, 0, 0);
  const double range = cv::norm(from_base);
  const Eigen::Vector3d sight = Eigen::Vector3d(from_base[0], from_base[1], from_base[2]) / range;
  const double variance = sight.dot(covariance.topLeftCorner<3, 3>() * sight);
  return TagPose{middle, matx_of(pose.turn), range, std::sqrt(variance), covariance, matx_of(other.pose.turn), share};
}

}  // namespace pizarra::vision
