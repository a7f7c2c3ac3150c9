#pragma once

// The cell as solids to draw: what stands still, and what a snapshot of the world shows.
//
//   const Scene scene = moving_scene(config, {.cubes = cubes, .joints = joints});      // before still_solids(config)

#include <optional>

#include "drivers/arm/kinematics.hpp"
#include "drivers/simulation/render/solid.hpp"

namespace pizarra::simulation {

// All that can be seen to move, at one instant.
struct Snapshot {
  struct Cube {
    Eigen::Isometry3d pose;
    CubeMarks marks;
    bool present;
    BodyShape shape;
  };
  std::vector<Cube> cubes;
  arm::Joints joints{};
  double opening_mm = 0;
  std::optional<Eigen::Vector3d> fist_mm;
};

// Ids of decals: of a cube's mark on one of its six faces, and of the end effector's triangle.
inline int mark_id(std::size_t cube, int face) { return 2 + static_cast<int>(cube) * 6 + face; }
inline constexpr int effector_id = 1;

struct Scene {
  std::vector<Solid> solids;
  std::vector<Points> shadows;  // convex, on the table, one for each thing that casts one
  // Hard ones on the table, where there is a second lamp, and the part of the light that they take.
  std::vector<Points> hard_shadows = {};
  float hard_shadow_dark = 0;
};

// Table and pedestal, far to near.
std::vector<Solid> still_solids(const WorldConfig& config);
Scene moving_scene(const WorldConfig& config, const Snapshot& snapshot);

}  // namespace pizarra::simulation
