#pragma once

// The three axes that place the wrist centre, for every build: where they put it, and every way to put it somewhere.
// Without the track; base frame.
//
//   const Placement at = place(model, posture);
//   const Ways ways = ways_to(model, at.wrist_mm, heading_deg);      // that posture among them

#include <optional>

#include "drivers/arm/angles.hpp"
#include "drivers/arm/posture.hpp"

namespace pizarra::arm {

struct Placement {
  Eigen::Vector3d wrist_mm;  // the wrist centre
  // z the direction in which the wrist points at pitch 0; with the tool down it is that of the tool frame.
  Eigen::Matrix3d forearm;
};

Placement place(const ArmModel& model, const Posture& posture);

// Ways to put the wrist centre at a point: front and back, elbow above and below. Limits are not looked at.
struct Ways {
  std::array<std::array<double, 3>, 8> ways;  // of two places, where the wrist may be at either
  std::size_t count = 0;
  void add(double a, double b, double c) { ways[count++] = {a, b, c}; }
  void append(const Ways& others) {
    for (std::size_t i = 0; i < others.count; ++i) ways[count++] = others.ways[i];
  }
};

// How axis 1 may stand so that a point lies in the links' plane: ahead of axis 1, or behind it. None where the plane
// passes further off than the point. `heading_deg` is as in ways_to().
struct Bearing {
  double front_deg;
  double back_deg;
  double radius_mm;  // of the point, along the plane
};
std::optional<Bearing> bearing_of(const ArmModel& model, const Eigen::Vector3d& point, double heading_deg);

// `heading_deg` is where axis 1 stands when the wrist centre is on it, and any direction would do.
Ways ways_to(const ArmModel& model, const Eigen::Vector3d& wrist_mm, double heading_deg);

inline constexpr double on_axis_1_mm = 1e-6;  // nearer to it the wrist centre counts as on axis 1

// The furthest that the wrist centre comes from the foot of axis 1.
double longest_reach_mm(const ArmModel& model);

}  // namespace pizarra::arm
