#pragma once

// Exact kinematics of a six-axis arm with a spherical wrist (ArmModel).
//
// Convention (thesis, Table B.3): th1 = 90 + j2 and th2 = 90 + j2 + j3 are the elevations of upper arm and forearm; the
// tool points straight down where j5 = -180 - j2 - j3 and j4 = 0. Base frame: x forward, y left, z up, origin on the
// table under axis 1. The tool frame's z is the approach direction, its y the direction in which the fingers close, its
// origin the grip centre. With the tool down and the wrist turned back by j1 the fingers close along the base's y.

#include <Eigen/Geometry>

#include "drivers/arm/arm_model.hpp"
#include "lisp/result.hpp"

namespace pizarra {

using ToolPose = Eigen::Isometry3d;  // mm, grip centre in the base frame

ToolPose forward(const ArmModel& model, const Joints& joints);

// The joints for a tool pose that lie nearest `near` within the limits. Failures: unreachable, joint-limit (names the
// axis).
Result<Joints> inverse(const ArmModel& model, const ToolPose& pose, const Joints& near);

// Which axis is beyond its limits, if any, as a failure `joint-limit`.
Result<void> check_limits(const ArmModel& model, const Joints& joints);

}  // namespace pizarra
