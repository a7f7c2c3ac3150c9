#include "programs/chaos/workspace.hpp"

#include <cmath>

#include "drivers/arm/kinematics.hpp"

namespace pizarra::chaos {

namespace {

double bearing(const Eigen::Vector3d& at) { return std::atan2(at.y(), at.x()); }

}  // namespace

Workspace::Workspace(const simulation::WorldConfig& config) : arm_(config.arm) {}

// With the tool held as in the ready pose, turned there.
bool Workspace::reaches(const Eigen::Vector3d& centre) const {
  arm::ToolPose pose = arm::forward(arm_, arm_.ready);
  const double turn = bearing(centre) - bearing(pose.translation());
  pose.linear() = Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitZ()) * pose.linear();
  pose.translation() = centre;
  return arm::inverse(arm_, pose, arm_.ready).has_value();
}

story::WorldState Workspace::within(story::WorldState world) const {
  for (auto& [name, cube] : world.cubes) {
    const Eigen::Vector3d centre(cube.x_mm, cube.y_mm, cube.z_mm);
    const bool there = cube.held || (cube.z_mm > 0 && reaches(centre));
    cube.gone = cube.gone || !there;
  }
  return world;
}

}  // namespace pizarra::chaos
