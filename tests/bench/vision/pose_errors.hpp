#pragma once

// How far the poses that the eyes tell are from the truth, and how often that is within two of the spreads that they
// tell: modulo the mark's symmetry, and of two tilts that look alike the nearer one.
//
//   PoseTally tally;
//   tally.count({"circle", place, turn}, *found->pose, model.base_line_mm / 2);
//   tally.rms_deg(), tally.ranges.said() ...

#include <string>

#include "agents/vision/sight/mark_pose.hpp"

namespace pizarra::bench {

inline constexpr double degrees_a_rad = 180 / CV_PI;

struct PosedMark {
  std::string mark;
  cv::Vec3d place_mm;  // from the left camera
  cv::Matx33d turn = cv::Matx33d::eye();
};

cv::Matx33d turned_about(const cv::Vec3d& rad);

// Of errors, each with the spread that was told.
struct Spreads {
  int told = 0;
  int within = 0;  // two spreads

  void count(const cv::Vec3d& off, const cv::Vec3d& along, const Eigen::Matrix3d& covariance);
  double percent() const { return 100.0 * within / std::max(1, told); }
  std::string said() const;
};

struct PoseTally {
  int shown = 0;
  int told = 0;
  int flips_told = 0;  // the other tilt may be it as well
  double squares = 0;
  Spreads angles = {};  // of the tilt, about two axes in the mark's plane
  Spreads ranges = {};
  Spreads places = {};  // beside the line of sight, either way

  // `beside_mm`: from the left camera to where the pose is told from.
  void count(const PosedMark& truth, const vision::MarkPose& pose, double beside_mm);
  double rms_deg() const;
};

}  // namespace pizarra::bench
