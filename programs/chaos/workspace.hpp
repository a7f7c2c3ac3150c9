#pragma once

// Where a cell can have a cube at all: before both cameras, whatever stands before it, and where the arm reaches. A
// cube that was pushed out of there is as good as taken away.
//
//   const Workspace workspace(config);
//   const story::WorldState had = workspace.within(world);          // those outside are gone

#include <optional>

#include "agents/coordinator/geometry/camera_view.hpp"
#include "drivers/simulation/world_config.hpp"
#include "programs/story/world_state.hpp"

namespace pizarra::chaos {

class Workspace {
 public:
  explicit Workspace(const simulation::WorldConfig& config);

  story::WorldState within(story::WorldState world) const;

 private:
  bool shows(const Eigen::Vector3d& centre) const;
  bool reaches(const Eigen::Vector3d& centre) const;

  std::optional<coordinator::CameraView> view_;  // none: a head turns the cameras everywhere
  arm::ArmModel arm_;
  double cube_mm_;
};

}  // namespace pizarra::chaos
