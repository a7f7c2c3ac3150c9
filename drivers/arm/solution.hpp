#pragma once

// Every way in which an arm can take a pose, and the best of them: what inverse() stands on. No failures are worded
// here, so that a search may ask often.
//
//   const Solution best = best_solution(model, pose, reading.joints);
//   if (best.found && best.excess == 0) move_to(best.joints);

#include <Eigen/Geometry>

#include "drivers/arm/kinematics.hpp"

namespace pizarra::arm {

struct Solution {
  bool found = false;  // whether there is a way at all, whatever the limits
  Joints joints;
  double excess = 0;  // by how much axes are beyond their limits, all together
};

// Least beyond the limits, then nearest to `near`; the track stands as in `near`.
Solution best_solution(const ArmModel& model, const ToolPose& pose, const Joints& near);

// The wrist centre of a pose.
Eigen::Vector3d wrist_of(const ArmModel& model, const ToolPose& pose);

// How far beyond a range a reading is, 0 within; what rounding may add to a joint that stands on its limit is within.
double excess_of(const Range& range, double reading);

// The least that an axis which folds or pitches has left to its limits or stops, degrees.
double margin_of(const ArmModel& model, const Joints& joints);

}  // namespace pizarra::arm
