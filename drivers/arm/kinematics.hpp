#pragma once

// Exact kinematics of a six-axis arm with a spherical wrist (ArmModel).
//
// Convention (thesis, Table B.3): th1 = 90 + j2 and th2 = 90 + j2 + j3 are the elevations of upper arm and forearm; the
// tool points straight down where j5 = -180 - j2 - j3 and j4 = 0. Base frame: x forward, y left, z up, origin on the
// table under axis 1. The tool frame's z is the approach direction, its y the direction in which the fingers close, its
// origin the grip centre. With the tool down and the wrist turned back by j1 the fingers close along the base's y.
//
// Signs: positive j1 turns from x towards y (anticlockwise from above); positive j2, j3 and j5 raise what they carry;
// positive j4 and j6 turn about the negative approach direction, so that with the tool down a positive j6 turns the
// fingers the way a positive j1 does: tool down is the rotation Rz(j1 + j6) Rx(180), and turned back means j6 = -j1.
//
//   R = Rz(j1) R0 Ry(90 + j2 + j3) Rz(-j4) Ry(j5) Rz(-j6),  R0 = columns (z, -y, x): the level forearm's frame

#include <Eigen/Geometry>

#include "drivers/arm/arm_model.hpp"
#include "lisp/result.hpp"

namespace pizarra {

using ToolPose = Eigen::Isometry3d;  // mm, grip centre in the base frame

ToolPose forward(const ArmModel& model, const Joints& joints);

// The joints for a tool pose that lie nearest `near` within the limits (least sum of squares; axes that turn more than
// once take the nearest turn). Where the pose leaves an axis free (wrist centre on axis 1, forearm and tool in line),
// it stays as in `near`. Failures: unreachable, joint-limit (of the solution that is least beyond; names the axis).
Result<Joints> inverse(const ArmModel& model, const ToolPose& pose, const Joints& near);

// Which axis is beyond its limits, if any, as a failure `joint-limit`, or `not-finite`; the subject is the axis,
// from 1.
Result<void> check_limits(const ArmModel& model, const Joints& joints);

// A rotation as rx, ry, rz degrees, turned about the fixed x, then y, then z axis; each in (-180, 180].
std::array<double, 3> fixed_angles(const Eigen::Matrix3d& rotation);

}  // namespace pizarra
