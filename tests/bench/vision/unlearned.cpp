#include "tests/bench/vision/unlearned.hpp"

#include <cmath>

namespace pizarra::bench {
namespace {

Shape regular(int corners) {
  Outline out;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * CV_PI * i / corners;
    out.emplace_back(24 * std::sin(angle), -24 * std::cos(angle));
  }
  return {out};
}

// Its upper side is three quarters of the lower one.
Shape trapezoid() { return {{{-16.5, -20.95}, {16.5, -20.95}, {22, 19.05}, {-22, 19.05}}}; }

Shape parallelogram() { return {{{-14, -20}, {26, -20}, {14, 20}, {-26, 20}}}; }

}  // namespace

const std::array<UnlearnedShape, 6>& unlearned_shapes() {
  static const std::array<UnlearnedShape, 6> shapes = {{{"pentagon", true, regular(5)},
                                                        {"hexagon", true, regular(6)},
                                                        {"heptagon", true, regular(7)},
                                                        {"octagon", true, regular(8)},
                                                        {"trapezoid", true, trapezoid()},
                                                        {"parallelogram", false, parallelogram()}}};
  return shapes;
}

}  // namespace pizarra::bench
