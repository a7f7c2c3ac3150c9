#pragma once

// Exact kinematics of every arm that an ArmModel describes.
//
// Base frame: x forward, y left, z up, origin on the table under axis 1 (where the track's value is 0). The tool
// frame's z is the approach direction, its y the direction in which the fingers close, its origin the grip centre. With
// the tool down and its spin taken back the fingers close along the base's y.
//
// Signs of the values (arm_model.hpp): positive turn goes from x towards y (anticlockwise from above); positive
// shoulder, elbow and pitch raise what they carry; positive roll and spin turn about the negative approach direction,
// so that with the tool down positive spin turns the fingers the way positive turn does: tool down is Rz(turn + spin)
// Rx(180).
//
//   R = Rz(turn) R0 Ry(elevation of the forearm) Rz(-roll) Ry(pitch) Rz(-spin),  R0 = columns (z, -y, x)
//
// The thesis' convention of the CRS-F3 (Table B.3): th1 = 90 + j2 is the elevation of the upper arm, th2 = 90 + j2 + j3
// that of the forearm; the tool is down where j5 = -180 - j2 - j3 and j4 = 0.
//
//   const Result<Joints> there = inverse(model, pose, joints);       // nearest to where the arm stands
//   forward(model, *there);                                          // pose again

#include <Eigen/Geometry>

#include "drivers/arm/arm_model.hpp"
#include "lisp/result.hpp"

namespace pizarra::arm {

using ToolPose = Eigen::Isometry3d;  // mm, grip centre in the base frame

ToolPose forward(const ArmModel& model, const Joints& joints);

// The joints for a tool pose that lie nearest `near` within the limits (least sum of squares; axes that turn more than
// once take the nearest turn). Where the pose leaves an axis free (wrist centre on axis 1, forearm and tool in line),
// it stays as in `near`. So does a track, unless the arm could not reach the pose from there, or only within
// `track_margin_deg` of a limit: then it goes the least way to where the arm can. Failures: unreachable, joint-limit
// (of the solution that is least beyond; names the axis).
Result<Joints> inverse(const ArmModel& model, const ToolPose& pose, const Joints& near);
inline constexpr double track_margin_deg = 3;

// The same with the track where it stands.
Result<Joints> inverse_in_place(const ArmModel& model, const ToolPose& pose, const Joints& near);

// The same with the track elsewhere, so that no other axis turns by more than `most_deg`; the track goes the least way.
Result<Joints> inverse_elsewhere(const ArmModel& model, const ToolPose& pose, const Joints& near, double most_deg);

// The pose nearest `pose`, at the same point, that the arm's wrist can take: the same for six axes; an arm whose wrist
// cannot leave the plane that axis 1 turns has the tool's direction turned into that plane.
ToolPose nearest_attainable(const ArmModel& model, const ToolPose& pose, const Joints& near);

// The axis that is beyond its limits or stops, if any, as a failure `joint-limit`, or `not-finite`, or `bad-joints`
// where their number is not the arm's; the subject is the axis, from 1.
Result<void> check_limits(const ArmModel& model, const Joints& joints);

// The wrist centre as seen from axis 2, in the plane that the arm stretches in: d ahead, h above, mm.
struct Stretch {
  Eigen::Vector3d ahead;  // unit, level
  double d_mm;
  double h_mm;
};
Stretch stretch_of(const ArmModel& model, const Joints& joints);

// The points that an arm is drawn through: foot, shoulder, elbow (where there is one), wrist centre, flange.
std::vector<Eigen::Vector3d> skeleton(const ArmModel& model, const Joints& joints);

// A rotation as rx, ry, rz degrees, turned about the fixed x, then y, then z axis; each in (-180, 180].
std::array<double, 3> fixed_angles(const Eigen::Matrix3d& rotation);

}  // namespace pizarra::arm
