#pragma once

// What else lies about in a scene: bars, rings, angles, arcs, zigzag strokes and specks, of any tone. None has the
// shape of a mark, nor could have in any view a camera might have of one.

#include "tests/bench/vision/scene.hpp"

namespace pizarra::bench {

// Adds up to `most` pieces where they touch no mark.
void add_clutter(Scene& scene, int most, Random& random);

}  // namespace pizarra::bench
