#pragma once

// What a run draws of light, lenses and photographs. Most cells do without each of them, and what a cell's file has
// stays.
//
//   draw_scenery(cell, random.split("scenery"));
//   for (const std::string& line : describe_scenery(cell)) ...

#include <string>
#include <vector>

#include "blackboard/time/random.hpp"
#include "lisp/forms/cell_file.hpp"

namespace pizarra::chaos {

void draw_scenery(forms::CellDescription& cell, const Random& random);
// A line for each thing that the cell has.
std::vector<std::string> describe_scenery(const forms::CellDescription& cell);

}  // namespace pizarra::chaos
