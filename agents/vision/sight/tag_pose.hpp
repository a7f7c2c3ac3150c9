#pragma once

// Where a tag is and how it is turned, by its four corners in one image, or in both of a pair, and the side of its
// square.
//
//   const std::optional<TagPose> pose = tag_pose(model, left.corners, 44, &right.corners);
//   pose->middle_mm, pose->turn, pose->range_spread_mm
//
// The likelier one of both poses that look nearly alike (plane_solve.hpp), with how far corners may be off.

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <opencv2/core.hpp>
#include <optional>

#include "drivers/camera/stereo_camera.hpp"

namespace pizarra::vision {

struct TagPose {
  cv::Vec3d middle_mm;                     // from the left camera: x right, y down, z along its axis
  cv::Matx33d turn;                        // its axes: right, down and away, as it is read
  double range_mm;                         // from the middle of the base line
  double range_spread_mm;                  // a standard deviation, by how far its corners may be off
  Eigen::Matrix<double, 6, 6> covariance;  // of the middle, mm, then of a small turn about the camera's axes, rad
  // The other tilt that looks nearly alike, and how likely that is, 0 to 1.
  cv::Matx33d other_turn;
  double share_of_other = 0;
};

using SquareCorners = std::array<cv::Point2f, 4>;  // clockwise from the tag's own upper left one, px

// `right`: in the right image, where that shows it; then the side is only about known. Nothing where they are no
// square's.
std::optional<TagPose> tag_pose(const camera::StereoModel& model, const SquareCorners& left, double side_mm,
                                const SquareCorners* right = nullptr);

// Of a square that fills, as all its points, this root of the product of both principal standard deviations.
inline double side_of_square(double face_mm) { return std::sqrt(12.0) * face_mm; }
inline double face_of_square(double side_mm) { return side_mm / std::sqrt(12.0); }

}  // namespace pizarra::vision
