#pragma once

// Solids as one eye sees them, and the order in which they must be painted: the far ones first.
//
// Of two convex solids that do not enter each other a plane separates them, and the one on the eye's side may hide the
// other, never the reverse; the order follows from all pairs whose silhouettes overlap in the image. It is exact,
// however the solids lie, as long as no three hide each other in a ring.
//
//   for (const Solid& solid : solids) seen.push_back(see(eye, solid));
//   for (const std::size_t i : paint_order(eye, solids, seen)) paint(seen[i]);

#include "drivers/simulation/render/eye.hpp"
#include "drivers/simulation/render/outline.hpp"
#include "drivers/simulation/render/seen_cells.hpp"
#include "drivers/simulation/render/seen_photograph.hpp"
#include "drivers/simulation/render/solid.hpp"

namespace pizarra::simulation {

struct SeenDecal {
  std::vector<Outline> parts;
  Colour colour;
  int id;
  std::optional<SeenCells> cells;
};

struct SeenFace {
  Outline outline;
  Outline seams;  // only the edges towards other seen faces
  Colour colour;
  std::vector<SeenDecal> decals;
  std::vector<Outline> shadows;
  float shadow_dark;
  std::optional<SeenPhotograph> photograph = {};
};

struct SeenSolid {
  Outline silhouette;
  std::vector<SeenFace> faces;  // those turned to the eye
  std::vector<Eigen::Vector2d> corners;
  Rect rect;  // empty when it cannot be seen at all
};

SeenSolid see(const Eye& eye, const Solid& solid);
std::vector<Eigen::Vector2d> see(const Eye& eye, const Points& points);

// Indices, far to near.
std::vector<std::size_t> paint_order(const Eye& eye, const std::vector<Solid>& solids,
                                     const std::vector<SeenSolid>& seen);

}  // namespace pizarra::simulation
