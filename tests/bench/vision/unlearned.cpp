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

// Half of its sides is round.
Shape rounded_square() {
  Outline out;
  constexpr int steps = 8;
  constexpr double radius = 11;
  for (int i = 0; i < 4 * (steps + 1); ++i) {
    const int corner = i / (steps + 1);
    const double angle = CV_PI / 2 * (corner + (i % (steps + 1)) / double{steps});
    const cv::Point2d around(corner == 0 || corner == 3 ? radius : -radius, corner < 2 ? radius : -radius);
    out.push_back(around + radius * cv::Point2d(std::cos(angle), std::sin(angle)));
  }
  return {out};
}

Shape ellipse() {
  Shape out = disc(22);
  for (cv::Point2d& p : out.front()) p.y *= 0.75;
  return out;
}

Shape parallelogram() { return {{{-14, -20}, {26, -20}, {14, 20}, {-26, 20}}}; }

}  // namespace

const std::array<UnlearnedShape, 8>& unlearned_shapes() {
  static const std::array<UnlearnedShape, 8> shapes = {{{"pentagon", true, regular(5)},
                                                        {"hexagon", true, regular(6)},
                                                        {"heptagon", true, regular(7)},
                                                        {"octagon", true, regular(8)},
                                                        {"trapezoid", true, trapezoid()},
                                                        {"rounded square", false, rounded_square()},
                                                        {"ellipse", false, ellipse()},
                                                        {"parallelogram", false, parallelogram()}}};
  return shapes;
}

}  // namespace pizarra::bench
