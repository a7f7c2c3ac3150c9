#pragma once

// Whether another outline explains the edges of a mark better than the one that was registered with them (plane_fit).
// Two kinds are tried: one that runs around a round outline in waves, as a polygon does, and one whose corners are
// round where those of the outline are not. First the part is removed that a homography explains, such as a tilt. A
// cover or a shadow moves edges in one place; that is neither.
//
//   const double odds = odds_of_other_outline(sample.plane, fit);     // 1: it may as well be another one

#include "agents/vision/marks/plane_fit.hpp"

namespace pizarra::vision {

// How many times likelier another outline is than the registered one, by the edges of its outermost border; 0 where too
// few are found.
double odds_of_other_outline(const PlaneOutline& outline, const PlaneFit& fit);

}  // namespace pizarra::vision
