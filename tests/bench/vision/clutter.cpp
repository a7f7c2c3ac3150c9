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

using Piece = Shape (*)(Random&);
constexpr std::array<Piece, 6> pieces = {bar, ring, angle, crescent, zigzag, speck};

Outline arc(double radius, double from_deg, double to_deg) {
  Outline out;
  constexpr int steps = 24;
  for (int i = 0; i <= steps; ++i) {
    const double t = (from_deg + (to_deg - from_deg) * i / steps) * CV_PI / 180;
    out.emplace_back(radius * std::cos(t), radius * std::sin(t));
  }
  return out;
}

// A part of a disc, from a third to a half of it, to its middle.
Shape sector(Random& random) {
  Outline out = arc(0.5, 0, random.uniform(120, 180));
  out.emplace_back(0, 0);
  return {out};
}

// A square with a roof.
Shape house(Random& random) {
  const double roof = random.uniform(0.15, 0.3);
  return {{{-0.35, 0.4}, {-0.35, -0.2}, {0, -0.2 - roof}, {0.35, -0.2}, {0.35, 0.4}}};
}

Shape trapezoid(Random& random) {
  const double upper = random.uniform(0.4, 0.6) / 2;
  return {{{-upper, -0.4}, {upper, -0.4}, {0.5, 0.4}, {-0.5, 0.4}}};
}

Shape kite(Random& random) {
  const double wide_at = random.uniform(-0.28, -0.2);
  return {{{0, -0.5}, {0.35, wide_at}, {0, 0.5}, {-0.35, wide_at}}};
}

// A disc with a point.
Shape drop(Random& random) {
  const double length = random.uniform(0.6, 0.75);
  const double touches_deg = std::acos(0.4 / length) * 180 / CV_PI;
  Outline out = arc(0.4, touches_deg, 360 - touches_deg);
  out.emplace_back(length, 0);
  return {out};
}

constexpr std::array<Piece, 5> solid_pieces = {sector, house, trapezoid, kite, drop};

}  // namespace

void add_clutter(Scene& scene, int most, bool solids, Random& random) {
  std::vector<Piece> chosen(pieces.begin(), pieces.end());
  if (solids) chosen.insert(chosen.end(), solid_pieces.begin(), solid_pieces.end());
  const camera::StereoModel& camera = scene_camera();
  const auto count = static_cast<int>(random.below(static_cast<std::uint64_t>(most) + 1));
  for (int i = 0; i < count; ++i) {
    const double across = random.uniform(8, 60);
    const cv::Point2d at(random.uniform(0, camera.width), random.uniform(0, camera.height));
    const Shape piece = chosen[random.below(chosen.size())](random);
    const double level = random.uniform(10, 160);
    const double turn = random.uniform(0, 360);
    const bool touches = std::ranges::any_of(scene.marks, [&](const SceneMark& mark) {
      return cv::norm(at - mark.centre) < across / 2 + 44 * scale_at(mark.depth_mm);
    });
    if (!touches) scene.things.push_back({.shape = placed(piece, at, across, turn), .level = level});
  }
}

}  // namespace pizarra::bench
