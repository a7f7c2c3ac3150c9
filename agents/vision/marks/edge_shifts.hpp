#pragma once

// Some errors move all edges of a side together, so that no scatter of theirs shows them.
//
//   note_shifts(outline, widths_px2, fit);        // fit.edges: is_straight, at
//
// Blur mixes an edge with the other border of a bend near it: such an edge is not straight. It moves the edges of an
// arc to the arc's inside, by half of the curvature times the blur's variance along the border; that is undone. How
// wide the edges themselves are says how the image is blurred, in every direction, by motion too.

#include <span>

#include "agents/vision/marks/plane_fit.hpp"

namespace pizarra::vision {

// `widths_px2`: of each edge's change along its normal, a variance.
void note_shifts(const PlaneOutline& outline, std::span<const double> widths_px2, PlaneFit& fit);

}  // namespace pizarra::vision
