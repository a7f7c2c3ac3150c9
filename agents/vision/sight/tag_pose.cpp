#include "agents/vision/sight/tag_pose.hpp"

#include <opencv2/calib3d.hpp>
#include <vector>

namespace pizarra::vision {
namespace {

// Of a corner along x, and along y: a standard deviation, measured of tags in any light, noise and blur.
constexpr double corner_spread_px = 0.15;
// Farther from where the pose puts them no corners of a square are, as a part of its side.
constexpr double most_off_share = 0.05;

// As OpenCV wants a square's corners: x right, y up, the middle at 0.
std::vector<cv::Point3d> square_of(double side_mm) {
  const double half = side_mm / 2;
  return {{-half, half, 0}, {half, half, 0}, {half, -half, 0}, {-half, -half, 0}};
}

// Of the range, by that of each corner: the first three unknowns are the turn, the next three the place.
double variance_of_range(const cv::Mat& slopes, const cv::Vec3d& sight) {
  const cv::Mat by_unknowns = slopes.colRange(0, 6);
  const cv::Mat normal = by_unknowns.t() * by_unknowns;
  const cv::Mat1d covariance = normal.inv(cv::DECOMP_SVD);
  const cv::Mat1d of_place = covariance(cv::Rect(3, 3, 3, 3));
  const cv::Mat1d along = cv::Mat(sight);
  const cv::Mat1d variance = along.t() * of_place * along;
  return corner_spread_px * corner_spread_px * variance(0, 0);
}

}  // namespace

std::optional<TagPose> tag_pose(const camera::StereoModel& model, const std::array<cv::Point2f, 4>& corners,
                                double side_mm) {
  const std::vector<cv::Point3d> square = square_of(side_mm);
  const std::vector<cv::Point2d> seen(corners.begin(), corners.end());
  const cv::Matx33d camera(model.focal_px, 0, model.centre_x_px, 0, model.focal_px, model.centre_y_px, 0, 0, 1);
  std::vector<cv::Mat> turns;
  std::vector<cv::Mat> places;
  // The likelier pose first.
  if (cv::solvePnPGeneric(square, seen, camera, cv::noArray(), turns, places, false, cv::SOLVEPNP_IPPE_SQUARE) == 0) {
    return std::nullopt;
  }
  cv::Vec3d turn(turns.front());
  cv::Vec3d middle(places.front());
  cv::solvePnPRefineLM(square, seen, camera, cv::noArray(), turn, middle);
  std::vector<cv::Point2d> expected;
  cv::Mat slopes;
  cv::projectPoints(square, turn, middle, camera, cv::noArray(), expected, slopes);
  const double side_px = cv::arcLength(std::vector<cv::Point2f>(corners.begin(), corners.end()), true) / 4;
  const double off_px = cv::norm(expected, seen, cv::NORM_INF);
  if (!(middle[2] > 0) || !(off_px < most_off_share * side_px)) return std::nullopt;
  const cv::Vec3d from_base = middle - cv::Vec3d(model.base_line_mm / 2, 0, 0);
  const double range = cv::norm(from_base);
  cv::Matx33d turned;
  cv::Rodrigues(turn, turned);
  return TagPose{middle, turned * cv::Vec3d(0, 0, 1), range,
                 std::sqrt(variance_of_range(slopes, from_base * (1 / range)))};
}

}  // namespace pizarra::vision
