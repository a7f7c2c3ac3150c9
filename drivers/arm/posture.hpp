#pragma once

// An arm's axes as the kinematics sees them, the same for every arm, and how they translate to what the arm's own axes
// read: signs, zeros, and which axis is counted from the base (the thesis' Table B.3).
//
//   Posture posture = posture_of(model, joints);
//   posture.pitch_deg += 10;
//   const Joints raised = joints_of(model, posture);

#include "drivers/arm/arm_model.hpp"

namespace pizarra::arm {

// Elevations are above the horizontal.
struct Posture {
  // Of the three axes that place the wrist, as the build has them:
  //   articulated: turn, elevation of the upper arm (th1), elevation of the forearm (th2 less its bend), degrees
  //   polar: turn, elevation, mm from the shoulder to the wrist centre
  //   scara: turn, elbow, mm that the lift is up
  //   gantry: mm along x, y, z
  std::array<double, 3> place{};
  double roll_deg = 0;
  double pitch_deg = 0;  // against the forearm
  double spin_deg = 0;
  double track_mm = 0;
};

Posture posture_of(const ArmModel& model, const Joints& joints);
Joints joints_of(const ArmModel& model, const Posture& posture);

// How far the last of the three leads the wrist's frame above the horizontal: scara and gantry hold it straight down.
double forearm_elevation_deg(const ArmModel& model, const Posture& posture);

// The readings that the axis can take with the others where they are: its limits, and, of an axis that is counted from
// the base, the part of them within its stops.
Range range_of(const ArmModel& model, const Joints& joints, std::size_t axis);

}  // namespace pizarra::arm
