#pragma once

// The order in which solids must be painted: the far ones first.
//
// Of two convex solids that do not enter each other a plane separates them, and the one on the eye's side may hide the
// other, never the reverse; the order follows from all pairs whose silhouettes overlap in the image. It is exact,
// however the solids lie, as long as no three hide each other in a ring.
//
//   for (const Solid& solid : solids) seen.push_back(see(eye, solid));
//   for (const std::size_t i : paint_order(eye, solids, seen)) paint(seen[i]);

#include "drivers/simulation/render/seen_solid.hpp"

namespace pizarra::simulation {

// Indices, far to near.
std::vector<std::size_t> paint_order(const Eye& eye, const std::vector<Solid>& solids,
                                     const std::vector<SeenSolid>& seen);

}  // namespace pizarra::simulation
