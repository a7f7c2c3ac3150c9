#pragma once

// Shapes that nobody learned and that look more or less like those that are: convex, filled, of a mark's size.

#include <array>

#include "tests/bench/vision/outline.hpp"

namespace pizarra::bench {

struct UnlearnedShape {
  const char* name;
  // What no view of a learned shape can be: by a parallelogram a camera cannot know that it is no turned square, by an
  // ellipse that it is no turned circle, and a square with round corners is one that was badly cut, or is blurred.
  bool no_view_of_a_mark;
  Shape shape;  // about 44 mm across, around the centroid
};

const std::array<UnlearnedShape, 8>& unlearned_shapes();

}  // namespace pizarra::bench
