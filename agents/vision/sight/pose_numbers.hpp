#pragma once

// A pose as numbers that a person reads.
//
//   const cv::Vec3d turned = angles_deg(pose.turn);
//   const std::array<double, 6> spreads = spreads_of(pose);     // of x, y, z and of turns about these

#include <array>

#include "agents/vision/sight/mark_pose.hpp"

namespace pizarra::vision {

// Degrees about x, then y, then z.
cv::Vec3d angles_deg(const cv::Matx33d& turn);
// Standard deviations of the place, mm, and of small turns about the camera's axes, degrees.
std::array<double, 6> spreads_of(const MarkPose& pose);

}  // namespace pizarra::vision
