#pragma once

// The rows play in cells whose camera was measured, so that no time goes into that: the numbers are those that
// `calibrate hand-eye examples/01-blocks/cell.scm` finds.

#include "lisp/forms/camera_pose.hpp"

namespace pizarra::bench {

inline constexpr forms::BelievedCamera measured_camera{
    .pose = {.at_mm = {1314.605, -9.069, 191.048}, .pan_deg = 0.504, .tilt_deg = -0.704, .roll_deg = 1.802},
    .sure_mm = 0.468,
    .sure_deg = 0.013,
    .mark_mm = {29.667, 0.043, -65.973}};

}  // namespace pizarra::bench
