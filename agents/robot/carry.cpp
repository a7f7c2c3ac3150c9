#include "agents/robot/carry.hpp"

#include <algorithm>
#include <cmath>

namespace pizarra::robot {

namespace {

// So short a piece of a leg (degrees, or mm of an axis that slides) is as good as straight.
constexpr double piece_length = 5;

// The fastest that the grip centre goes sideways between the two, at the axes' full speeds.
double fastest_mm_s(const arm::ArmModel& model, const arm::Joints& from, const arm::Joints& to) {
  double widest = 0;
  double full_speed_s = 0;
  for (std::size_t axis = 0; axis < to.size(); ++axis) {
    const double way = std::abs(to[axis] - from[axis]);
    widest = std::max(widest, way);
    full_speed_s = std::max(full_speed_s, way / model.axes[axis].speed);
  }
  const double pieces = std::ceil(widest / piece_length);
  double furthest_mm = 0;
  Eigen::Vector3d before = arm::forward(model, from).translation();
  for (double piece = 1; piece <= pieces; ++piece) {
    arm::Joints at = to;
    for (std::size_t axis = 0; axis < to.size(); ++axis) at[axis] = std::lerp(from[axis], to[axis], piece / pieces);
    const Eigen::Vector3d now = arm::forward(model, at).translation();
    furthest_mm = std::max(furthest_mm, (now - before).head<2>().norm());
    before = now;
  }
  return pieces > 0 ? furthest_mm * pieces / full_speed_s : 0;
}

}  // namespace

double carry_speed(const arm::ArmModel& model, const arm::Joints& from, const std::vector<arm::Joints>& waypoints) {
  double fastest = carry_mm_s;
  const arm::Joints* at = &from;
  for (const arm::Joints& to : waypoints) {
    fastest = std::max(fastest, fastest_mm_s(model, *at, to));
    at = &to;
  }
  return carry_mm_s / fastest;
}

}  // namespace pizarra::robot
