#pragma once

// Shapes that nobody learned and that look more or less like those that are: convex, filled, of a mark's size.

#include <array>

#include "tests/bench/vision/outline.hpp"

namespace pizarra::bench {

struct UnlearnedShape {
  const char* name;
  // What no view of a learned shape can be: a parallelogram may be a turned square, and an ellipse a turned circle, as
  // far as one camera can know. A square with round corners may be badly cut, or blurred.
  bool no_view_of_a_mark;
  Shape shape;  // about 44 mm across, around the centroid
};

const std::array<UnlearnedShape, 8>& unlearned_shapes();

}  // namespace pizarra::bench
