#include "agents/vision/sight/tag_pose.hpp"

#include <Eigen/Dense>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>
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

using Matrix6 = Eigen::Matrix<double, 6, 6>;

// By that of each corner: half the inverse of the normal matrix of a small turn and step about the camera's axes.
Matrix6 covariance_of(const std::vector<cv::Point3d>& square, const cv::Matx33d& turned, const cv::Vec3d& middle,
                      double focal_px) {
  Matrix6 normal = Matrix6::Zero();
  for (const cv::Point3d& corner : square) {
    const cv::Vec3d arm = turned * cv::Vec3d(corner.x, corner.y, corner.z);
    const cv::Vec3d at = arm + middle;
    Eigen::Matrix<double, 2, 3> by_place;
    by_place << 1, 0, -at[0] / at[2], 0, 1, -at[1] / at[2];
    by_place *= focal_px / at[2];
    Eigen::Matrix3d by_turn;
    by_turn << 0, arm[2], -arm[1], -arm[2], 0, arm[0], arm[1], -arm[0], 0;
    Eigen::Matrix<double, 2, 6> slopes;
    slopes << by_place, by_place * by_turn;
    normal += slopes.transpose() * slopes;
  }
  return corner_spread_px * corner_spread_px * normal.inverse();
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
  cv::projectPoints(square, turn, middle, camera, cv::noArray(), expected);
  const double side_px = cv::arcLength(std::vector<cv::Point2f>(corners.begin(), corners.end()), true) / 4;
  const double off_px = cv::norm(expected, seen, cv::NORM_INF);
  if (!(middle[2] > 0) || !(off_px < most_off_share * side_px)) return std::nullopt;
  const cv::Vec3d from_base = middle - cv::Vec3d(model.base_line_mm / 2, 0, 0);
  const double range = cv::norm(from_base);
  cv::Matx33d turned;
  cv::Rodrigues(turn, turned);
  const Matrix6 covariance = covariance_of(square, turned, middle, model.focal_px);
  const Eigen::Vector3d sight = Eigen::Vector3d(from_base[0], from_base[1], from_base[2]) / range;
  const double variance = sight.dot(covariance.topLeftCorner<3, 3>() * sight);
  // From up and towards the camera to down and away.
  const cv::Matx33d read(1, 0, 0, 0, -1, 0, 0, 0, -1);
  return TagPose{middle, turned * read, range, std::sqrt(variance), covariance};
}

}  // namespace pizarra::vision
