#pragma once

// A second lamp, a point from which light comes. Its shadows are hard. They fall on the table and on cubes.
//
//   add_light(lamp, scene.solids);                                         // their colours, no shadow yet
//   add_shadows(lamp, scene.solids, cubes);                                // on the first so many of them
//   const std::vector<Points> on_table = shadows_on(lamp, border, up, casters);

#include <span>

#include "drivers/simulation/render/solid.hpp"

namespace pizarra::simulation {

void add_light(const LampConfig& lamp, std::vector<Solid>& solids);
// Of all of them on the first `receivers`.
void add_shadows(const LampConfig& lamp, std::vector<Solid>& solids, std::size_t receivers);

// The part of the light on a face that the lamp's shadow takes; 0 where the face is turned away from it.
double part_in_shadow(const LampConfig& lamp, const Eigen::Vector3d& on, const Eigen::Vector3d& normal);
// Of each of them on a flat convex border, anticlockwise as seen from where its normal points.
std::vector<Points> shadows_on(const LampConfig& lamp, const Points& border, const Eigen::Vector3d& normal,
                               std::span<const Solid* const> casters);

}  // namespace pizarra::simulation
