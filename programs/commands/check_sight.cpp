#include "programs/commands/check_sight.hpp"

#include <Eigen/Core>
#include <algorithm>

#include "agents/coordinator/geometry/camera_view.hpp"

namespace pizarra::programs {

namespace {

// The middle of its front, where the cameras look at it. A cube is listed behind the one that it stands on.
Eigen::Vector3d front_of(const simulation::WorldConfig& config, const simulation::CubeConfig& cube) {
  const double half_mm = config.edge_mm(cube) / 2;
  if (cube.on.empty()) return {cube.x_mm + half_mm, cube.y_mm, half_mm};
  const simulation::CubeConfig& below = *std::ranges::find(config.cubes, cube.on, &simulation::CubeConfig::name);
  const double below_half_mm = config.edge_mm(below) / 2;
  return front_of(config, below) + Eigen::Vector3d(half_mm - below_half_mm, 0, half_mm + below_half_mm);
}

}  // namespace

std::vector<std::string> cubes_out_of_sight(const simulation::WorldConfig& config) {
  std::vector<std::string> names;
  if (!config.camera.head.empty()) return names;
  const camera::StereoModel& model = config.camera.model;
  const coordinator::CameraView view(config.camera.pose, {.width_px = static_cast<double>(model.width),
                                                          .height_px = static_cast<double>(model.height),
                                                          .focal_px = model.focal_px,
                                                          .centre_x_px = model.centre_x_px,
                                                          .centre_y_px = model.centre_y_px,
                                                          .base_line_mm = model.base_line_mm});
  for (const simulation::CubeConfig& cube : config.cubes) {
    if (!view.shows(front_of(config, cube), config.edge_mm(cube) / 2)) names.push_back(cube.name);
  }
  return names;
}

}  // namespace pizarra::programs
