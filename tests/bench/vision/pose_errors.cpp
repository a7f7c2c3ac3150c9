#include "tests/bench/vision/pose_errors.hpp"

#include <cmath>
#include <fmt/format.h>
#include <opencv2/calib3d.hpp>

namespace pizarra::bench {
namespace {

cv::Vec3d away_of(const cv::Matx33d& turn) { return {turn(0, 2), turn(1, 2), turn(2, 2)}; }

// By which the truth differs from what is told, about the camera's axes, rad: the least of those that look the same. Of
// a circle that of its normal.
cv::Vec3d off_rad(const std::string& mark, const cv::Matx33d& told, const cv::Matx33d& truth) {
  if (mark == "circle") {
    const cv::Vec3d across = away_of(told).cross(away_of(truth));
    const double sine = cv::norm(across);
    return sine > 0 ? std::atan2(sine, away_of(told).dot(away_of(truth))) / sine * across : cv::Vec3d();
  }
  const int turns = mark == "triangle" ? 3 : 4;
  cv::Vec3d least(CV_PI, CV_PI, CV_PI);
  for (int i = 0; i < turns; ++i) {
    cv::Vec3d off;
    cv::Rodrigues(truth * turned_about({0, 0, 2 * CV_PI * i / turns}) * told.t(), off);
    if (cv::norm(off) < cv::norm(least)) least = off;
  }
  return least;
}

}  // namespace

cv::Matx33d turned_about(const cv::Vec3d& rad) {
  cv::Matx33d out;
  cv::Rodrigues(rad, out);
  return out;
}

void Spreads::count(const cv::Vec3d& off, const cv::Vec3d& along, const Eigen::Matrix3d& covariance) {
  const Eigen::Vector3d way(along[0], along[1], along[2]);
  ++told;
  within += std::abs(off.dot(along)) < 2 * std::sqrt(way.dot(covariance * way)) ? 1 : 0;
}

std::string Spreads::said() const { return fmt::format("{:.1f} %", percent()); }

void PoseTally::count(const PosedMark& truth, const vision::MarkPose& pose, double beside_mm) {
  ++told;
  cv::Vec3d off = off_rad(truth.mark, pose.turn, truth.turn);
  if (pose.flipped) {
    ++flips_told;
    const cv::Vec3d other = off_rad(truth.mark, pose.flipped->turn, truth.turn);
    if (cv::norm(other) < cv::norm(off)) off = other;
  }
  squares += off.dot(off);
  for (const int column : {0, 1}) {
    angles.count(off, {pose.turn(0, column), pose.turn(1, column), pose.turn(2, column)},
                 pose.covariance.bottomRightCorner<3, 3>());
  }
  const cv::Vec3d place = truth.place_mm - cv::Vec3d(beside_mm, 0, 0);
  const cv::Vec3d sight = place / cv::norm(place);
  const cv::Vec3d down = cv::normalize(sight.cross(cv::Vec3d(1, 0, 0)));
  const Eigen::Matrix3d of_place = pose.covariance.topLeftCorner<3, 3>();
  ranges.count(pose.place_mm - place, sight, of_place);
  for (const cv::Vec3d& beside : {down, down.cross(sight)}) places.count(pose.place_mm - place, beside, of_place);
}

double PoseTally::rms_deg() const { return degrees_a_rad * std::sqrt(squares / std::max(1, told)); }

}  // namespace pizarra::bench
