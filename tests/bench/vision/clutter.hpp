#pragma once

// What else lies about in a scene: bars, rings, angles, arcs, zigzag strokes and specks, of any tone; and, where they
// are asked for, solid convex things: parts of discs, houses, trapezoids, kites and drops. None has the shape of a
// mark, nor could have in any view a camera might have of one. (What is rounder than these, as a hexagon, passes for a
// circle where it is small and noisy; unlearned.hpp has such shapes.)

#include "tests/bench/vision/scene.hpp"

namespace pizarra::bench {

// Adds up to `most` pieces where they touch no mark.
void add_clutter(Scene& scene, int most, bool solids, Random& random);

}  // namespace pizarra::bench
