#pragma once

// A move through many waypoints as few legs, for controllers that take one target after another: a leg goes to its end
// either with all axes in proportion, or with the tool along a straight line.
//
//   for (const Leg& leg : legs_of(model, joints, waypoints)) ...
//
// The legs stay within 0.05 degrees (or mm) of the waypoints' axes, or within 0.2 mm and 0.05 degrees of their line.

#include "drivers/arm/kinematics.hpp"

namespace pizarra::arm {

struct Leg {
  Joints to;
  bool straight = false;  // the tool goes along a line and keeps its direction
  double seconds = 0;     // that its waypoints take with the axes at their full speed
};

std::vector<Leg> legs_of(const ArmModel& model, const Joints& from, const std::vector<Joints>& waypoints);

// How long the way from one to the other takes with the slowest axis at its full speed.
double seconds_between(const ArmModel& model, const Joints& from, const Joints& to);

// Whether the readings are the same place, to within what controllers round, degrees or mm.
inline constexpr double same_place = 0.01;
bool are_same_place(const Joints& one, const Joints& other, double within = same_place);

}  // namespace pizarra::arm
