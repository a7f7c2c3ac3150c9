#pragma once

// Whether a look at a mark tells that a straight edge hides a part of it. A circle without a segment is no tilted
// circle. But a square without a strip along one side is a tilted square, and a triangle without one is a smaller
// triangle.
//
//   sample.shows_cuts = shows_cuts(sample.plane);      // each registered outline is then one of the whole mark

#include "agents/vision/marks/plane_outline.hpp"

namespace pizarra::vision {

// False without an outline.
bool shows_cuts(const PlaneOutline& outline);

}  // namespace pizarra::vision
