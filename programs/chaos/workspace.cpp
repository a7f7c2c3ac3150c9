#include "programs/chaos/workspace.hpp"

#include <cmath>

#include "drivers/arm/kinematics.hpp"

namespace pizarra::chaos {

namespace {

// From a mark's middle to its edge, of a cube's edge: a mark that is cut off is not recognised.
constexpr double mark_half = 0.37;

coordinator::CameraModel model_of(const camera::StereoModel& model) {
  return {.width_px = static_cast<double>(model.width),
          .height_px = static_cast<double>(model.height),
          .focal_px = model.focal_px,
          .centre_x_px = model.centre_x_px,
          .centre_y_px = model.centre_y_px,
          .base_line_mm = model.base_line_mm};
}

double bearing(const Eigen::Vector3d& at) { return std::atan2(at.y(), at.x()); }

}  // namespace

Workspace::Workspace(const simulation::WorldConfig& config) : arm_(config.arm), cube_mm_(config.cube_mm) {
  if (config.camera.head.empty()) view_.emplace(config.camera.pose, model_of(config.camera.model));
}

// The face that it turns to the cameras.
bool Workspace::shows(const Eigen::Vector3d& centre) const {
  if (!view_) return true;
  return view_->shows(centre - cube_mm_ / 2 * view_->away(), mark_half * cube_mm_);
}

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
    const bool there = cube.held || (shows(centre) && reaches(centre));
    cube.gone = cube.gone || !there;
  }
  return world;
}

}  // namespace pizarra::chaos
