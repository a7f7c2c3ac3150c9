#pragma once

// How fast the arm goes while something is between its fingers. A cube that slips flies on as fast as the tool went
// sideways: a fast swing throws it off the table.
//
//   const double part = carry_speed(model, joints, waypoints);      // of the axes' speeds

#include "drivers/arm/kinematics.hpp"

namespace pizarra::robot {

// A cube that falls from 300 mm flies for a quarter of a second, and slides: from this speed it comes to rest some
// 120 mm further on, two of its edges.
inline constexpr double carry_mm_s = 400;

// The part of the axes' speeds, above 0 and at most 1, at which the grip centre goes sideways no faster than that.
// Straight up and down it may go at full speed.
double carry_speed(const arm::ArmModel& model, const arm::Joints& from, const std::vector<arm::Joints>& waypoints);

}  // namespace pizarra::robot
