#pragma once

// Convex polygons in a plane, anticlockwise.
//
//   const Polygon shadow = part_within(border, convex_hull(points));

#include "drivers/simulation/render/mark_shape.hpp"

namespace pizarra::simulation {

Polygon convex_hull(std::vector<Eigen::Vector2d> points);
// What of the polygon lies within the border; empty where nothing does.
Polygon part_within(const Polygon& border, Polygon polygon);

}  // namespace pizarra::simulation
