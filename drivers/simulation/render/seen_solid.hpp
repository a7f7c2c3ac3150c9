#pragma once

// A solid as one eye sees it: outlines in the image, in the colours of the faces that are turned to the eye.
//
//   const SeenSolid seen = see(eye, solid);
//   paint(canvas, seen, seen.rect);

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

}  // namespace pizarra::simulation
