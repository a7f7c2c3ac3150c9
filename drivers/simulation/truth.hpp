#pragma once

// The truth about the cell, told geometrically: for the judge, the hand, the scripted person and pages of the console
// alone. The forms stand in world.hpp.
//
//   Result<Datum> at = where_seen(cell, left, "circle");      // the pixel that a person would click on

#include "drivers/simulation/physics/physical_cell.hpp"
#include "drivers/simulation/render/eye.hpp"

namespace pizarra::simulation {

// Visible is what both eyes see: an object in one image alone has no depth.
Datum truth_of(const Cell& cell, const Eye& left, const Eye& right);
// Failures: unknown-object, not-seen.
Result<Datum> where_seen(const Cell& cell, const Eye& left, std::string_view name);
Datum describe_scene(const Cell& cell, const WorldConfig& config, const forms::CameraPose& camera);

}  // namespace pizarra::simulation
