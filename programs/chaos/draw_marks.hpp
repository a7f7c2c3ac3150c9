#pragma once

// Cells whose cubes do not all bear one learned shape on all faces: a cube may wear a tag, or another tag on each face,
// which the eyes know as one body. Nobody clicks on these. Most cells have neither.
//
//   draw_marks(cell, random.split("marks"));
//   for (const std::string& line : describe_marks(cell)) ...

#include <string>
#include <vector>

#include "blackboard/time/random.hpp"
#include "lisp/forms/cell_file.hpp"

namespace pizarra::chaos {

// A cell whose own file has tags keeps those alone. Every cell with tags takes larger images, since the cells of a tag
// are smaller than a shape. Many cubes are too small and too far away for tags.
void draw_marks(forms::CellDescription& cell, const Random& random);
// A line for each cube with tags.
std::vector<std::string> describe_marks(const forms::CellDescription& cell);
// Whether a cube wears one tag on all of its faces, and whether one wears another on each.
bool has_tagged_cubes(const forms::CellDescription& cell);
bool has_bodies(const forms::CellDescription& cell);

}  // namespace pizarra::chaos
