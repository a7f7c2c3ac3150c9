#pragma once

// The photographs that a cell puts into its simulated world, read from their files.
//
//   const Result<void> pictured = put_pictures(config, description);

#include "drivers/simulation/world_config.hpp"
#include "lisp/forms/cell_file.hpp"

namespace pizarra::launcher {

// Failure: corrupt-frame, which names the file and where the cell file names it.
Result<void> put_pictures(simulation::WorldConfig& config, const forms::CellDescription& description);

}  // namespace pizarra::launcher
