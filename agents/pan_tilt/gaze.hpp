#pragma once

// The direction in which the head must turn so that its camera looks at a point.
//
//   const Gaze gaze = gaze_at(mount, {450, -165, 30});     // degrees of the head's pan and tilt
//
// `mount` is how the camera looks while the head is in its middle, and about which axes that turns it. The point's
// angle from the middle of the turned camera's image is added to the turn, until none is left.

#include <array>

#include "lisp/forms/camera_pose.hpp"

namespace pizarra::pan_tilt {

struct Gaze {
  double pan_deg;
  double tilt_deg;
};

// `point_mm` in the base frame.
Gaze gaze_at(const forms::CameraPose& mount, const std::array<double, 3>& point_mm);

}  // namespace pizarra::pan_tilt
