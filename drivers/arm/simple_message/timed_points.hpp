#pragma once

// A move as a controller wants it that is told when the arm is to be where, and how fast: the places of a way through
// waypoints, so often, with the axes' speeds there. The pace is ramped up and down, every axis stays within its speed,
// and a controller that joins the places by cubics with these speeds keeps to the way.
//
//   for (const TimedPoint& point : timed_points(model, joints, waypoints, 0.5)) ...    // the first: where it stands
//
// Between waypoints all axes move in proportion. A corner is rounded within one step of time.

#include <vector>

#include "drivers/arm/arm_model.hpp"

namespace pizarra::arm {

struct TimedPoint {
  double time_s = 0;
  Joints joints;
  Joints speeds;  // a second
};

// `speed` is 0 to 1 of the axes' speeds.
std::vector<TimedPoint> timed_points(const ArmModel& model, const Joints& from, const std::vector<Joints>& waypoints,
                                     double speed);

}  // namespace pizarra::arm
