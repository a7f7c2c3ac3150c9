#pragma once

// Why the ground around a mark is uneven, by the print beside it. Light changes print and ground alike: a shadow takes
// the same part of both, a lamp's reflection adds to both. A thing that hides a part leaves the print as it is.
//
//   std::vector<PrintBeside> places;       // around the outline
//   if (light_rather_than_cover(places, noise) > 0.9) ...

#include <span>

#include "agents/vision/marks/ground_step.hpp"

namespace pizarra::vision {

// At a place of the outline: the ground right outside, and the print inside.
struct PrintBeside {
  std::size_t part;  // of around_parts
  cv::Point2d at;    // px from the mark's middle
  double ground;     // grey levels
  double print;
};

// How likely light makes the ground uneven, rather than what hides a part, 0 to 1. `noise` is that of the image.
double light_rather_than_cover(std::span<const PrintBeside> places, double noise);

}  // namespace pizarra::vision
