#pragma once

// What the marks look like: each as convex polygons that may overlap.
//
//   for (const Polygon& part : mark_shape(Mark::cross)) ...      // x right, y up, mm, about the mark's centroid

#include <Eigen/Core>
#include <vector>

#include "drivers/simulation/world_config.hpp"

namespace pizarra::simulation {

using Polygon = std::vector<Eigen::Vector2d>;

// The cube that a mark of this size is made for.
inline constexpr double marked_cube_mm = 60;

const std::vector<Polygon>& mark_shape(Mark mark);

}  // namespace pizarra::simulation
