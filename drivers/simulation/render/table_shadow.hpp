#pragma once

// The shadow that a thing casts on the table under the first lamp, which stands high above it. How dark and how soft it
// is painted, StereoRenderer says; the shadows of a second lamp are hard (second_lamp.hpp).
//
//   add_shadow(scene.shadows, solid, config.table);

#include "drivers/simulation/render/solid.hpp"

namespace pizarra::simulation {

// Where the solid keeps a lamp high above the table from shining; none beside the table.
void add_shadow(std::vector<Points>& shadows, const Solid& solid, const TableConfig& table);

}  // namespace pizarra::simulation
