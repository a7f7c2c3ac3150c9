#include "drivers/arm/link_geometry.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pizarra {

namespace {

double radians(double deg) { return deg * std::numbers::pi / 180; }
double degrees(double rad) { return rad * 180 / std::numbers::pi; }

// A cosine that rounding may have put a hair beyond 1.
double angle_of(double cosine) { return std::acos(std::clamp(cosine, -1.0, 1.0)); }

}  // namespace

LinkGeometry link_geometry(const ArmModel& model, const Joints& joints) {
  const double a = model.upper_arm_mm;
  const double b = model.forearm_mm;
  const double th1 = radians(90 + joints[1]);
  const double th2 = radians(90 + joints[1] + joints[2]);
  const double included = std::numbers::pi - th1 + th2;
  const double c = std::sqrt(a * a + b * b - 2 * a * b * std::cos(included));
  const bool above = joints[2] <= 0;
  const double at_shoulder = c > 0 ? angle_of((a * a + c * c - b * b) / (2 * a * c)) : 0;
  const double alpha = th1 - (above ? at_shoulder : -at_shoulder);
  return {c * std::sin(alpha), c * std::cos(alpha), c, degrees(alpha), above};
}

std::optional<LinkJoints> link_joints(const ArmModel& model, const LinkGeometry& links) {
  const double a = model.upper_arm_mm;
  const double b = model.forearm_mm;
  const double c = std::hypot(links.h_mm, links.d_mm);
  const double side = links.elbow_above ? 1 : -1;
  if (!(c <= a + b) || !(c >= std::abs(a - b)) || c == 0) return std::nullopt;
  const double included = angle_of((a * a + b * b - c * c) / (2 * a * b));
  const double at_shoulder = angle_of((a * a + c * c - b * b) / (2 * a * c));
  const double th1 = std::atan2(links.h_mm, links.d_mm) + side * at_shoulder;
  return LinkJoints{degrees(th1) - 90, side * (degrees(included) - 180)};
}

}  // namespace pizarra
