#pragma once

// Where a cell can have a cube at all: where the arm reaches. A cube that was pushed out of there is as good as taken
// away. One that no image shows is not: the cell is to look for it.
//
//   const Workspace workspace(config);
//   const story::WorldState had = workspace.within(world);          // those outside are gone

#include "drivers/simulation/world_config.hpp"
#include "programs/story/world_state.hpp"

namespace pizarra::chaos {

class Workspace {
 public:
  explicit Workspace(const simulation::WorldConfig& config);

  story::WorldState within(story::WorldState world) const;

 private:
  bool reaches(const Eigen::Vector3d& centre) const;

  arm::ArmModel arm_;
};

}  // namespace pizarra::chaos
