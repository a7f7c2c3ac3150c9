#pragma once

// The direction in which the head must turn so that its camera looks at a point.
//
//   const Gaze gaze = gaze_at(mount, {450, -165, 30});     // degrees of the head's pan and tilt
//
// The camera pair turns about the centre of its base line, in which the head's two axes meet; `mount` is how it looks
// while the head is in its middle. Source: the angles of a direction, atan2(y, -x) about z and atan2(z, hypot(x, y)).

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
