#pragma once

// What every arm driver refuses before anything goes over its wire: waypoints beyond the limits, what is no number.

#include <cmath>

#include "drivers/arm/kinematics.hpp"

namespace pizarra {

// Failures: not-finite, bad-request, bad-joints, joint-limit (with the axis).
inline Result<void> check_move(const ArmModel& model, const std::vector<Joints>& waypoints, double speed) {
  if (!std::isfinite(speed)) return fail("not-finite", "the speed is not a number");
  if (waypoints.empty() || speed <= 0 || speed > 1) {
    return fail("bad-request", "a move has waypoints, and a speed above 0 and at most 1", to_datum(speed));
  }
  for (const Joints& joints : waypoints) {
    const Result<void> within = check_limits(model, joints);
    if (!within) return within;
  }
  return {};
}

// Failure: not-finite.
inline Result<void> check_opening(double opening_mm) {
  if (!std::isfinite(opening_mm)) return fail("not-finite", "the opening is not a number");
  return {};
}

}  // namespace pizarra
