#pragma once

// The requests that make the gripper's fingers clumsy, as World has them (world.hpp).

#include "drivers/simulation/physics/physical_cell.hpp"
#include "lisp/datum.hpp"
#include "lisp/result.hpp"

namespace pizarra::simulation {

// Failures: bad-request; not-held, where nothing is held that could slip.
Result<void> make_clumsy(Cell& cell, const Datum& request);

}  // namespace pizarra::simulation
