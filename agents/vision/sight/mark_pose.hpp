#pragma once

// Where a mark is and how it is turned: six numbers and how far they may be off.
//
//   if (const std::optional<MarkPose> pose = pose_of(sight.model(), object, pair, range)) pose->place_mm, pose->turn
//
//   const cv::Vec3d turned = angles_deg(pose->turn);
//
// Of a tag by its corners, of a shape by its outline; where the pair knows the range, at that.

#include <Eigen/Core>
#include <array>
#include <optional>

#include "agents/vision/objects/learned.hpp"
#include "agents/vision/sight/stereo.hpp"

namespace pizarra::vision {

struct PlanePose;
struct SeenPair;
struct SeenRange;

struct MarkPose {
  cv::Vec3d place_mm;  // of its middle, from the middle of the base line: x right, y down, z ahead
  cv::Matx33d turn;    // its axes, as it lay when it was learned: right, down, and away from who looks at it
  Eigen::Matrix<double, 6, 6> covariance;  // of the place, mm, then of a small turn about the camera's axes, rad
  // The other tilt that looks nearly alike, where it may be it: how it would be turned then, and how likely that is.
  struct Flipped {
    cv::Matx33d turn;
    double share;
  };
  std::optional<Flipped> flipped = {};
};

// `range`: of it, where that is known. Nothing of a slim shape of which was not learned how it lies.
std::optional<MarkPose> pose_of(const camera::StereoModel& model, const LearnedObject& object, const SeenPair& pair,
                                const std::optional<SeenRange>& range);
// Of a shape, by its plane.
MarkPose pose_of(const camera::StereoModel& model, const PlanePose& plane, const std::optional<SeenRange>& range);

// As a person reads it: degrees about x, then y, then z.
cv::Vec3d angles_deg(const cv::Matx33d& turn);
// Standard deviations of the place, mm, and of small turns about the camera's axes, degrees.
std::array<double, 6> spreads_of(const MarkPose& pose);

}  // namespace pizarra::vision
