#include "agents/console/reach_outline.hpp"

#include <numbers>

#include "drivers/arm/kinematics.hpp"
#include "drivers/arm/placement.hpp"

namespace pizarra::console {

namespace {

constexpr int directions = 72;
constexpr double step_mm = 10;

bool reaches(const arm::ArmModel& model, const Eigen::Vector3d& point, double angle) {
  arm::ToolPose pose = arm::ToolPose::Identity();
  pose.translation() = point;
  pose.linear() = (Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()) *
                   Eigen::AngleAxisd(std::numbers::pi, Eigen::Vector3d::UnitX()))
                      .toRotationMatrix();
  return arm::inverse_in_place(model, pose, model.ready).has_value();
}

}  // namespace

ReachOutline reach_outline(const arm::ArmModel& model, double height_mm) {
  ReachOutline outline{.height_mm = height_mm, .parts = {}};
  Eigen::Vector3d foot = arm::skeleton(model, model.ready).front();
  foot.z() = height_mm;
  const double furthest = arm::longest_reach_mm(model);
  for (int i = 0; i < directions; ++i) {
    const double angle = 2 * std::numbers::pi * i / directions;
    const Eigen::Vector3d ahead(std::cos(angle), std::sin(angle), 0);
    ReachOutline::Part part;
    for (double away = step_mm; away <= furthest; away += step_mm) {
      if (!reaches(model, foot + away * ahead, angle)) continue;
      if (part.to_mm == 0) part.from_mm = away;
      part.to_mm = away;
    }
    outline.parts.push_back(part);
  }
  return outline;
}

}  // namespace pizarra::console
