#include "tests/bench/vision/clutter.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace pizarra::bench {
namespace {

// All pieces are drawn 1 across, to be scaled.
Shape bar(Random& random) { return box(1, random.uniform(0.05, 0.3)); }

Shape ring(Random& random) {
  Shape out = disc(0.5);
  Outline hole = disc(0.5 * random.uniform(0.5, 0.8)).front();
  std::ranges::reverse(hole);
  out.push_back(hole);
  return out;
}

Shape angle(Random& random) {
  const double t = random.uniform(0.15, 0.35);
  return {{{-0.4, -0.4}, {0.4, -0.4}, {0.4, -0.4 + t}, {-0.4 + t, -0.4 + t}, {-0.4 + t, 0.4}, {-0.4, 0.4}}};
}

Shape crescent(Random& random) {
  Outline out;
  const double depth = random.uniform(0.2, 0.6);
  constexpr int steps = 24;
  for (int i = 0; i <= steps; ++i) {
    const double t = CV_PI * i / steps;
    out.emplace_back(0.5 * std::cos(t), -0.5 * std::sin(t));
  }
  for (int i = steps; i >= 0; --i) {
    const double t = CV_PI * i / steps;
    out.emplace_back(0.5 * std::cos(t), -0.5 * depth * std::sin(t));
  }
  return {out};
}

// Letters, seen from afar.
Shape zigzag(Random& random) {
  Outline out;
  const double t = random.uniform(0.06, 0.15);
  constexpr int turns = 4;
  for (int i = 0; i <= turns; ++i) out.emplace_back(-0.5 + i / double{turns}, i % 2 == 0 ? -0.25 : 0.25 - t);
  for (int i = turns; i >= 0; --i) out.emplace_back(-0.5 + i / double{turns}, i % 2 == 0 ? -0.25 + t : 0.25);
  return {out};
}

// Smaller than any mark.
Shape speck(Random& random) { return disc(random.uniform(0.03, 0.065)); }

constexpr std::array<Shape (*)(Random&), 6> pieces = {bar, ring, angle, crescent, zigzag, speck};

}  // namespace

void add_clutter(Scene& scene, int most, Random& random) {
  const StereoModel& camera = scene_camera();
  const auto count = static_cast<int>(random.below(static_cast<std::uint64_t>(most) + 1));
  for (int i = 0; i < count; ++i) {
    const double across = random.uniform(8, 60);
    const cv::Point2d at(random.uniform(0, camera.width), random.uniform(0, camera.height));
    const Shape piece = pieces[random.below(pieces.size())](random);
    const double level = random.uniform(10, 160);
    const double turn = random.uniform(0, 360);
    const bool touches = std::ranges::any_of(scene.marks, [&](const SceneMark& mark) {
      return cv::norm(at - mark.centre) < across / 2 + 44 * scale_at(mark.depth_mm);
    });
    if (!touches) scene.things.push_back({.shape = placed(piece, at, across, turn), .level = level});
  }
}

}  // namespace pizarra::bench
