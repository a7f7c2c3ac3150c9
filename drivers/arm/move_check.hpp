#pragma once

// Checks that every arm driver makes. Before a move goes over its wire: waypoints within the limits, and real numbers.
// Of a reading: whether an arm of this file can stand there.
//
//   const Result<void> possible = check_move(model, waypoints, speed);
//   const Result<void> sound = check_reading(model, reading.joints);

#include <cmath>
#include <fmt/format.h>

#include "drivers/arm/kinematics.hpp"

namespace pizarra::arm {

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

// How far beyond a limit a controller may report an axis, degrees or mm.
inline constexpr double limit_slack = 1;

// Failure: joint-limit (with the axis).
inline Result<void> check_reading(const ArmModel& model, const Joints& joints) {
  for (std::size_t axis = 0; axis < model.axes.size(); ++axis) {
    const Range& limits = model.axes[axis].limits;
    const double at = joints[axis];
    if (at >= limits.low - limit_slack && at <= limits.high + limit_slack) continue;
    return fail("joint-limit",
                fmt::format("axis {} reads {:.2f}, beyond its {:g} to {:g}", axis + 1, at, limits.low, limits.high),
                to_datum(axis + 1));
  }
  return {};
}

// Failure: not-finite.
inline Result<void> check_opening(double opening_mm) {
  if (!std::isfinite(opening_mm)) return fail("not-finite", "the opening is not a number");
  return {};
}

}  // namespace pizarra::arm
