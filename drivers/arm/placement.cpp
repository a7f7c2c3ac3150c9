#include "drivers/arm/placement.hpp"

#include <algorithm>
#include <cmath>

namespace pizarra::arm {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double reach_slack = 1e-12;  // what rounding may add to the cosine of the elbow

// Approach along the forearm, which is raised `elevation_deg` in the plane that axis 1 turns.
Matrix3d forearm_frame(double turn_deg, double elevation_deg) {
  Matrix3d level;
  level.col(0) = Vector3d::UnitZ();
  level.col(1) = -Vector3d::UnitY();
  level.col(2) = Vector3d::UnitX();
  return about_z(turn_deg) * level * about_y(elevation_deg);
}

// The first link's direction and the second's, from the first link's root to a point `along`, `up` from it.
struct Links {
  double first_deg;
  double second_deg;
};
// `bend` -1: the second bends clockwise from the first (elbow above).
std::optional<Links> links_to(double a, double b, double along, double up, double bend) {
  const double cosine = (along * along + up * up - a * a - b * b) / (2 * a * b);
  if (!(std::abs(cosine) <= 1 + reach_slack)) return std::nullopt;
  const double elbow = bend * std::acos(std::clamp(cosine, -1.0, 1.0));
  const double first = std::atan2(up, along) - std::atan2(b * std::sin(elbow), a + b * std::cos(elbow));
  return Links{degrees(first), degrees(first + elbow)};
}

void add_upright(Ways& ways, const ArmModel& model, double turn_deg, double ahead_mm, double up_mm) {
  if (model.build == Build::polar) {
    ways.add(turn_deg, degrees(std::atan2(up_mm, ahead_mm)), std::hypot(up_mm, ahead_mm));
    return;
  }
  for (const double bend : {-1.0, 1.0}) {
    const auto links = links_to(model.upper_arm_mm, model.elbow_to_wrist_mm(), ahead_mm, up_mm, bend);
    if (links) ways.add(turn_deg, links->first_deg, links->second_deg - model.forearm_bend_deg());
  }
}

}  // namespace

Placement place(const ArmModel& model, const Posture& posture) {
  const auto& [first, second, third] = posture.place;
  if (model.build == Build::gantry) return {{first, second, model.height_mm + third}, forearm_frame(0, -90)};
  if (model.build == Build::scara) {
    const double a = radians(first);
    const double b = radians(first + second);
    return {{model.upper_arm_mm * std::cos(a) + model.forearm_mm * std::cos(b),
             model.upper_arm_mm * std::sin(a) + model.forearm_mm * std::sin(b), model.height_mm + third},
            forearm_frame(first + second, -90)};
  }
  double radius = model.offset_mm;
  double height = model.height_mm;
  if (model.build == Build::polar) {
    radius += third * std::cos(radians(second));
    height += third * std::sin(radians(second));
  } else {
    const double th1 = radians(second);
    const double th2 = radians(third + model.forearm_bend_deg());
    radius += model.upper_arm_mm * std::cos(th1) + model.elbow_to_wrist_mm() * std::cos(th2);
    height += model.upper_arm_mm * std::sin(th1) + model.elbow_to_wrist_mm() * std::sin(th2);
  }
  const double turn = radians(first);
  return {{radius * std::cos(turn) - model.side_mm * std::sin(turn),
           radius * std::sin(turn) + model.side_mm * std::cos(turn), height},
          forearm_frame(first, forearm_elevation_deg(model, posture))};
}

Ways ways_to(const ArmModel& model, const Vector3d& wrist, double heading_deg) {
  Ways ways;
  const double up = wrist.z() - model.height_mm;
  if (model.build == Build::gantry) {
    ways.add(wrist.x(), wrist.y(), up);
    return ways;
  }
  if (model.build == Build::scara) {
    for (const double bend : {-1.0, 1.0}) {
      const auto links = links_to(model.upper_arm_mm, model.forearm_mm, wrist.x(), wrist.y(), bend);
      if (links) ways.add(links->first_deg, links->second_deg - links->first_deg, up);
    }
    return ways;
  }
  const std::optional<Bearing> bearing = bearing_of(model, wrist, heading_deg);
  if (!bearing) return ways;
  add_upright(ways, model, bearing->front_deg, bearing->radius_mm - model.offset_mm, up);
  add_upright(ways, model, bearing->back_deg, -bearing->radius_mm - model.offset_mm, up);
  return ways;
}

std::optional<Bearing> bearing_of(const ArmModel& model, const Vector3d& point, double heading_deg) {
  const double away = std::hypot(point.x(), point.y());
  if (away < std::abs(model.side_mm)) return std::nullopt;
  const double direction = away > on_axis_1_mm ? degrees(std::atan2(point.y(), point.x())) : heading_deg;
  const double beside = model.side_mm == 0 ? 0 : degrees(std::asin(model.side_mm / away));
  const double radius = std::sqrt(away * away - model.side_mm * model.side_mm);
  return Bearing{direction - beside, direction + 180 + beside, radius};
}

double longest_reach_mm(const ArmModel& model) {
  double furthest =
      std::hypot(std::abs(model.offset_mm) + model.upper_arm_mm + model.elbow_to_wrist_mm(), model.side_mm) +
      std::abs(model.wrist_across_mm);
  double slide = 0;
  for (const Axis& axis : model.axes) {
    if (!slides(axis.role) || axis.role == Role::track) continue;
    const double low = axis.sense * axis.limits.low + axis.zero;
    const double high = axis.sense * axis.limits.high + axis.zero;
    slide += std::max(std::abs(low), std::abs(high));
  }
  return furthest + slide + std::abs(model.height_mm);
}

}  // namespace pizarra::arm
