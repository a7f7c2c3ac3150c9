#pragma once

// Which cubes of a simulated cell begin where the images do not show them whole. A cell that hides a cube may be meant
// so: `check` warns, and refuses nothing.
//
//   for (const std::string& name : cubes_out_of_sight(config)) ...

#include <string>
#include <vector>

#include "drivers/simulation/world_config.hpp"

namespace pizarra::programs {

// Of a sound configuration. None where the cameras stand on a pan-tilt unit, which can turn to them.
std::vector<std::string> cubes_out_of_sight(const simulation::WorldConfig& config);

}  // namespace pizarra::programs
