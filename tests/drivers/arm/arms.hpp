#pragma once

// Every arm that comes with the tree, and random ways for it to stand.

#include <cmath>
#include <gtest/gtest.h>

#include "blackboard/time/random.hpp"
#include "drivers/arm/arm_file.hpp"
#include "drivers/arm/kinematics.hpp"
#include "drivers/arm/posture.hpp"
#include "lisp/forms/arm_names.hpp"

namespace pizarra::arm {

inline std::vector<ArmModel> shipped_arms() {
  std::vector<ArmModel> arms;
  for (const std::string& name : forms::arm_names()) arms.push_back(shipped_arm(name).value());
  return arms;
}

// Anywhere within limits and stops; one in four of the axes on a limit where `edges` says so.
inline Joints random_joints(const ArmModel& model, Random& random, bool edges = false) {
  Joints joints(model.axes.size());
  for (std::size_t axis = 0; axis < joints.size(); ++axis) {
    const Range range = range_of(model, joints, axis);
    joints[axis] = random.uniform(range.low, range.high);
    if (!edges || random.uniform(0, 1) > 0.25) continue;
    joints[axis] = random.uniform(0, 1) < 0.5 ? range.low : range.high;
  }
  return joints;
}

inline double angle_between_deg(const ToolPose& a, const ToolPose& b) {
  // From the chord, because the trace cannot tell angles below 1e-6 degree apart.
  const double chord = (a.linear() - b.linear()).norm() / std::sqrt(8.0);
  return 2 * std::asin(std::min(1.0, chord)) * 180 / std::numbers::pi;
}

}  // namespace pizarra::arm
