#include "agents/vision/sight/widest_look.hpp"

#include <algorithm>
#include <cmath>

#include "agents/vision/marks/mark_outline.hpp"
#include "agents/vision/sight/covered_part.hpp"

namespace pizarra::vision {
namespace {

// How far the centre moves for every px that the standard deviation shrinks, where one along a side of a triangle is
// covered.
const double motion_by_side = std::sqrt(8.0);
// How much noise may take off an axis that is as wide as it was, as a part of it.
constexpr double slack = 0.01;
// How much of what is wider is taken over in a frame: noise alone widens nothing for long.
constexpr double part_taken_over = 0.3;

}  // namespace

WidestLook::Spreads WidestLook::spreads_of(const SeenMark& mark) {
  const double mean = (mark.width_px * mark.width_px + mark.height_px * mark.height_px) / 2;
  const auto root = [](double variance) { return std::sqrt(std::max(variance, 0.0)); };
  return {mark.width_px, mark.height_px, root(mean + mark.slant_px2), root(mean - mark.slant_px2)};
}

double WidestLook::off_if_covered_px(const SeenMark& now) const {
  if (!widest_) return 0;
  const Spreads spreads = spreads_of(now);
  double scale = triangle_ ? 1 : 0;
  for (std::size_t i = 0; i < spreads.size(); ++i) scale = std::max(scale, spreads[i] / (*widest_)[i]);
  double missing = 0;
  for (std::size_t i = 0; i < spreads.size(); ++i) missing = std::max(missing, scale * (*widest_)[i] - spreads[i]);
  return (triangle_ ? motion_by_side : motion_by_strip) * missing;
}

// A mark that is wider on one axis and narrower on another may be nearer and covered.
void WidestLook::follow(const SeenMark& now) {
  const Spreads spreads = spreads_of(now);
  if (!widest_) {
    widest_ = spreads;
    triangle_ = is_triangle(outline_of(now.signature));
    return;
  }
  Spreads& widest = *widest_;
  for (std::size_t i = 0; i < spreads.size(); ++i) {
    if (spreads[i] < (1 - slack) * widest[i]) return;
  }
  for (std::size_t i = 0; i < spreads.size(); ++i) widest[i] += part_taken_over * std::max(0.0, spreads[i] - widest[i]);
}

}  // namespace pizarra::vision
