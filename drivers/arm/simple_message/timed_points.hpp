#pragma once

// A move for controllers that are told where the arm shall be at which moment, and how fast: places along the way at
// regular times, with the axes' speeds there. The pace is ramped up and down, and every axis stays within its speed. A
// controller that joins the places by cubics with these speeds keeps to the way.
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
