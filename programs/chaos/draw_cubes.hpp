#pragma once

// How many cubes a run has and how large they are. Most cells have three to five, which images of 320x240 show well. A
// few have six to eight, with a wider row before cameras that stand farther away and take larger images.
//
//   draw_cubes(cell, random);
//   cell.cubes.size(); has_many_cubes(cell);

#include "blackboard/time/random.hpp"
#include "lisp/forms/cell_file.hpp"

namespace pizarra::chaos {

// A cell whose cubes have sizes of their own keeps these, and has no more than five. So does a cell whose file has
// tags, since the file says how large each tag is.
void draw_cubes(forms::CellDescription& cell, Random& random);
// Asked before tags are drawn.
bool has_tags_of_its_own(const forms::CellDescription& cell);
// More than five.
bool has_many_cubes(const forms::CellDescription& cell);

}  // namespace pizarra::chaos
