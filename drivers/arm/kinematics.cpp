#include "drivers/arm/kinematics.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <optional>
#include <vector>

namespace pizarra {

namespace {

using Eigen::AngleAxisd;
using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double limit_slack_deg = 1e-9;     // what rounding may add to a joint that stands on its limit
constexpr double reach_slack = 1e-12;        // the same for the cosine of the elbow
constexpr double singular_sine = 1e-7;       // below it the axes of joints 4 and 6 count as one
constexpr double singular_radius_mm = 1e-6;  // below it the wrist centre counts as on axis 1

double radians(double deg) { return deg * std::numbers::pi / 180; }
double degrees(double rad) { return rad * 180 / std::numbers::pi; }

Matrix3d about_y(double deg) { return AngleAxisd(radians(deg), Vector3d::UnitY()).toRotationMatrix(); }
Matrix3d about_z(double deg) { return AngleAxisd(radians(deg), Vector3d::UnitZ()).toRotationMatrix(); }

// The forearm's frame: approach along the forearm, which is raised `elevation_deg` in the plane that j1 turns.
Matrix3d forearm_frame(double j1, double elevation_deg) {
  Matrix3d level;
  level.col(0) = Vector3d::UnitZ();
  level.col(1) = -Vector3d::UnitY();
  level.col(2) = Vector3d::UnitX();
  return about_z(j1) * level * about_y(elevation_deg);
}

// The same direction of an axis, whole turns away, that lies nearest `near` within the limits; the nearest to the
// limits where none lies within.
double nearest_turn(double deg, double near_deg, const AxisLimits& limits) {
  double best = deg + 360 * std::round((near_deg - deg) / 360);
  if (best > limits.high_deg + limit_slack_deg) best -= 360 * std::ceil((best - limits.high_deg) / 360 - 1e-12);
  if (best < limits.low_deg - limit_slack_deg) {
    const double raised = best + 360 * std::ceil((limits.low_deg - best) / 360 - 1e-12);
    if (raised <= limits.high_deg + limit_slack_deg) best = raised;
  }
  return best;
}

double excess_deg(const AxisLimits& limits, double deg) {
  return std::max({0.0, limits.low_deg - limit_slack_deg - deg, deg - limits.high_deg - limit_slack_deg});
}

// j2 and j3 that put the wrist centre at distance d, height h from axis 2; `bend` -1 elbow above, +1 elbow below.
struct LinkAngles {
  double j2;
  double j3;
};
std::optional<LinkAngles> links_for(const ArmModel& model, double d_mm, double h_mm, double bend) {
  const double a = model.upper_arm_mm;
  const double b = model.forearm_mm;
  const double cosine = (d_mm * d_mm + h_mm * h_mm - a * a - b * b) / (2 * a * b);
  if (!(std::abs(cosine) <= 1 + reach_slack)) return std::nullopt;
  const double j3 = bend * std::acos(std::clamp(cosine, -1.0, 1.0));
  const double th1 = std::atan2(h_mm, d_mm) - std::atan2(b * std::sin(j3), a + b * std::cos(j3));
  return LinkAngles{degrees(th1) - 90, degrees(j3)};
}

struct WristAngles {
  double j4;
  double j5;
  double j6;
};

// Rz(-j4) Ry(j5) Rz(-j6) = `turned`, with j5 of the sign of `flip`.
WristAngles wrist_for(const Matrix3d& turned, double flip, double near_j4) {
  const double sine = std::hypot(turned(0, 2), turned(1, 2));
  const double j5 = degrees(std::atan2(flip * sine, turned(2, 2)));
  double j4 = near_j4;
  if (sine > singular_sine) j4 = -degrees(std::atan2(flip * turned(1, 2), flip * turned(0, 2)));
  const Matrix3d rest = about_z(j4) * turned;
  return {j4, j5, -degrees(std::atan2(rest(1, 0), rest(1, 1)))};
}

// Every way to reach the pose, whatever the limits: front and back, elbow above and below, wrist turned over or not.
std::vector<Joints> solutions(const ArmModel& model, const ToolPose& pose, const Joints& near) {
  const Matrix3d rotation = pose.linear();
  const Vector3d wrist = pose.translation() - (model.wrist_mm + model.tool_mm) * rotation.col(2);
  const double radius = std::hypot(wrist.x(), wrist.y());
  const double heading = radius > singular_radius_mm ? degrees(std::atan2(wrist.y(), wrist.x())) : near[0];
  const double h_mm = wrist.z() - model.base_height_mm;
  std::vector<Joints> found;
  for (const double side : {1.0, -1.0}) {
    const double j1 = nearest_turn(side > 0 ? heading : heading + 180, near[0], model.limits[0]);
    for (const double bend : {-1.0, 1.0}) {
      const auto links = links_for(model, side * radius - model.base_offset_mm, h_mm, bend);
      if (!links) continue;
      const Matrix3d turned = forearm_frame(j1, 90 + links->j2 + links->j3).transpose() * rotation;
      for (const double flip : {1.0, -1.0}) {
        const WristAngles angles = wrist_for(turned, flip, near[3]);
        const Joints raw{j1, links->j2, links->j3, angles.j4, angles.j5, angles.j6};
        Joints& joints = found.emplace_back();
        for (std::size_t axis = 0; axis < arm_axes; ++axis) {
          joints[axis] = nearest_turn(raw[axis], near[axis], model.limits[axis]);
        }
      }
    }
  }
  return found;
}

}  // namespace

ToolPose forward(const ArmModel& model, const Joints& joints) {
  const auto& [j1, j2, j3, j4, j5, j6] = joints;
  const double th1 = radians(90 + j2);
  const double th2 = radians(90 + j2 + j3);
  const double radius = model.base_offset_mm + model.upper_arm_mm * std::cos(th1) + model.forearm_mm * std::cos(th2);
  const double height = model.base_height_mm + model.upper_arm_mm * std::sin(th1) + model.forearm_mm * std::sin(th2);
  const double turn = radians(j1);
  const Vector3d wrist(radius * std::cos(turn), radius * std::sin(turn), height);

  ToolPose pose = ToolPose::Identity();
  pose.linear() = forearm_frame(j1, 90 + j2 + j3) * about_z(-j4) * about_y(j5) * about_z(-j6);
  pose.translation() = wrist + (model.wrist_mm + model.tool_mm) * pose.linear().col(2);
  return pose;
}

Result<Joints> inverse(const ArmModel& model, const ToolPose& pose, const Joints& near) {
  if (!pose.matrix().allFinite()) return fail("unreachable", "the pose holds a number that is not finite");
  std::optional<Joints> best;
  double best_excess = 0;
  double best_distance = 0;
  for (Joints& joints : solutions(model, pose, near)) {
    double excess = 0;
    double distance = 0;
    for (std::size_t axis = 0; axis < arm_axes; ++axis) {
      const AxisLimits& limits = model.limits[axis];
      excess += excess_deg(limits, joints[axis]);
      distance += (joints[axis] - near[axis]) * (joints[axis] - near[axis]);
    }
    if (!best || excess < best_excess || (excess == best_excess && distance < best_distance)) {
      best = joints;
      best_excess = excess;
      best_distance = distance;
    }
  }
  if (!best) {
    const Vector3d at = (pose.translation() * 10).array().round() / 10;
    return fail("unreachable", "the arm cannot reach this point with this tool direction",
                list("point"_sym, at.x(), at.y(), at.z()));
  }
  const Result<void> within = check_limits(model, *best);
  if (!within) return fail(within);
  for (std::size_t axis = 0; axis < arm_axes; ++axis) {
    (*best)[axis] = std::clamp((*best)[axis], model.limits[axis].low_deg, model.limits[axis].high_deg);
  }
  return *best;
}

Result<void> check_limits(const ArmModel& model, const Joints& joints) {
  for (std::size_t axis = 0; axis < arm_axes; ++axis) {
    const AxisLimits& limits = model.limits[axis];
    if (!std::isfinite(joints[axis])) {
      return fail("not-finite", fmt::format("axis {} is given no finite angle", axis + 1), to_datum(axis + 1));
    }
    if (excess_deg(limits, joints[axis]) == 0) continue;
    return fail("joint-limit",
                fmt::format("axis {} would stand at {:.2f} degrees, beyond its {:g} to {:g}", axis + 1, joints[axis],
                            limits.low_deg, limits.high_deg),
                to_datum(axis + 1));
  }
  return {};
}

std::array<double, 3> fixed_angles(const Matrix3d& rotation) {
  const double level = std::hypot(rotation(0, 0), rotation(1, 0));
  double rx = std::atan2(rotation(2, 1), rotation(2, 2));
  double rz = std::atan2(rotation(1, 0), rotation(0, 0));
  // With the y angle upright, x and z turn about one axis; z is then taken as 0.
  if (level < singular_sine) {
    rx = std::atan2(-rotation(1, 2), rotation(1, 1));
    rz = 0;
  }
  const double ry = std::atan2(-rotation(2, 0), level);
  const auto upper_half = [](double rad) { return rad <= -std::numbers::pi ? 180 : degrees(rad); };
  return {upper_half(rx), degrees(ry), upper_half(rz)};
}

}  // namespace pizarra
