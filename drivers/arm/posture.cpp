#include "drivers/arm/posture.hpp"

#include <algorithm>
#include <cmath>

namespace pizarra::arm {

namespace {

// Which of the three places the role sets.
std::size_t place_index(Role role) {
  switch (role) {
    case Role::shoulder:
    case Role::across:
      return 1;
    case Role::reach:
    case Role::lift:
      return 2;
    default:
      return 0;
  }
}

double* value_of(Posture& posture, Role role) {
  if (role == Role::roll) return &posture.roll_deg;
  if (role == Role::pitch) return &posture.pitch_deg;
  if (role == Role::spin) return &posture.spin_deg;
  if (role == Role::track) return &posture.track_mm;
  return &posture.place[place_index(role)];
}

std::size_t elbow_place(Build build) { return build == Build::articulated ? 2 : 1; }

}  // namespace

double forearm_elevation_deg(const ArmModel& model, const Posture& posture) {
  if (model.build == Build::articulated) return posture.place[2];
  if (model.build == Build::polar) return posture.place[1];
  return -90;
}

Posture posture_of(const ArmModel& model, const Joints& joints) {
  Posture posture;
  const Axis* elbow = nullptr;
  const Axis* pitch = nullptr;
  for (std::size_t i = 0; i < model.axes.size(); ++i) {
    const Axis& axis = model.axes[i];
    const double value = axis.sense * joints[i] + axis.zero;
    if (axis.role == Role::elbow) {
      posture.place[elbow_place(model.build)] = value;
      elbow = &axis;
    } else {
      *value_of(posture, axis.role) = value;
    }
    if (axis.role == Role::pitch) pitch = &axis;
  }
  const bool carried = model.build == Build::articulated && elbow != nullptr && !elbow->from_base;
  if (carried) posture.place[2] += posture.place[1];
  if (pitch != nullptr && pitch->from_base) posture.pitch_deg -= forearm_elevation_deg(model, posture);
  return posture;
}

Joints joints_of(const ArmModel& model, const Posture& posture) {
  Posture values = posture;
  Joints joints(model.axes.size());
  for (std::size_t i = 0; i < model.axes.size(); ++i) {
    const Axis& axis = model.axes[i];
    double value = 0;
    if (axis.role == Role::elbow) {
      value = posture.place[elbow_place(model.build)];
      if (model.build == Build::articulated && !axis.from_base) value -= posture.place[1];
    } else {
      value = *value_of(values, axis.role);
    }
    if (axis.role == Role::pitch && axis.from_base) value += forearm_elevation_deg(model, posture);
    joints[i] = axis.sense * (value - axis.zero);
  }
  return joints;
}

Range range_of(const ArmModel& model, const Joints& joints, std::size_t index) {
  const Axis& axis = model.axes[index];
  if (!axis.stops) return axis.limits;
  const Posture posture = posture_of(model, joints);
  // The reading of the axis with no angle between it and the link before.
  const double carrier = axis.role == Role::pitch ? forearm_elevation_deg(model, posture) : posture.place[1];
  const double level = axis.sense * (carrier - axis.zero);
  const double a = level + axis.sense * axis.stops->low;
  const double b = level + axis.sense * axis.stops->high;
  return {std::max(axis.limits.low, std::min(a, b)), std::min(axis.limits.high, std::max(a, b))};
}

}  // namespace pizarra::arm
