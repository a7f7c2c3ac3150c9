#pragma once

// Whether a look at a mark tells that a straight edge hides a part of it. A circle without a segment is no tilted
// circle. But a square without a strip along one side is a tilted square, and a triangle without one is a smaller
// triangle.
//
//   if (form_shows_cuts(sample.plane)) ...      // a straight edge over a part of it shows in its outline

#include "agents/vision/marks/plane_outline.hpp"

namespace pizarra::vision {

// False without an outline.
bool form_shows_cuts(const PlaneOutline& outline);

}  // namespace pizarra::vision
