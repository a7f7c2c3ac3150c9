#pragma once

// How a pan-tilt unit moves the camera on it: turned about the tilt axis first, which the pan axis then takes along.
//
//   const Eigen::Isometry3d stands = camera_frame(pose) * head_turn(pose, {.pan_deg = 8, .tilt_deg = -2});
//   stands * Eigen::Vector3d(0, 0, 850);          // in the base frame, what is 850 mm ahead of the turned camera
//
// A camera's frame: x to the right in the image, y down, z ahead of the base line's centre, mm.

#include <Eigen/Geometry>

#include "lisp/forms/camera_pose.hpp"

namespace pizarra::ptu {

// From the unit's middle: pan positive to image right, tilt positive upwards.
struct HeadTurn {
  double pan_deg = 0;
  double tilt_deg = 0;
  bool operator==(const HeadTurn&) const = default;
};

// The camera's frame in the base frame, while the unit is in its middle.
Eigen::Isometry3d camera_frame(const forms::CameraPose& pose);

// The frame of the turned camera in its frame of the middle.
Eigen::Isometry3d head_turn(const forms::CameraPose& pose, HeadTurn turn);

// The pose's own, or those of a unit of which nothing is known.
forms::HeadAxes axes_of(const forms::CameraPose& pose);

}  // namespace pizarra::ptu
