#include "agents/vision/sight/first_look.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "agents/vision/objects/mark_choice.hpp"
#include "agents/vision/sight/covered_part.hpp"
#include "agents/vision/sight/unyawed.hpp"

namespace pizarra::vision {
namespace {

// How far a length is off that was learned elsewhere, as a part of it: a standard deviation.
constexpr double learned_spread = 0.01;
// So many standard deviations noise hardly makes.
constexpr double clear = 3;
// How much likelier, as a logarithm, a turned face is that has just the plane that it should have: a nearer cover may
// be at any distance, and explains any plane.
constexpr double by_chance = 2;

// How far the centre of a triangle moves for every px that the root of the product of its standard deviations shrinks,
// where a corner is cut off along one side: two thirds of the root of 24. Along a whole side it is less.
const double motion_by_corner = std::sqrt(32.0 / 3);

double squared(double x) { return x * x; }

// Of the sizes that it was learned with the least that it is not clearly more than: what is larger than that one is a
// part of the next.
double whole_mm(const LearnedObject& object, double now_mm, double spread) {
  double next = 0;
  double largest = 0;
  for (const LearnedSample& sample : object.samples) {
    const double whole = sample.most_face_mm();
    largest = std::max(largest, whole);
    if (now_mm < whole * (1 + clear * spread) && (next == 0 || whole < next)) next = whole;
  }
  return next == 0 ? largest : next;
}

// How far off where it lost a part above or below, or to all sides.
double by_loss_px(const FaceSize& now, const SeenMark& left, double whole_mm) {
  const double slack = 2 * learned_spread;
  const FaceSize::Reading by_shape{squared(now.size_mm.value) * std::max(1.0, now.left_shown), 2 * now.size_mm.spread};
  const double whole_mm2 = squared(whole_mm);
  return off_if_missing_px(left,
                           std::max(missing(whole_mm2, now.area_mm2, slack), missing(whole_mm2, by_shape, slack)));
}

// Half the squared deviations.
double unlikely(double off, double spread) { return squared(off / spread) / 2; }

// How likely it is that something covers a part rather than that it is tilted about the horizontal, where it looks
// smaller than it was learned: 1 where no tilt is to be seen. What is as far away shows none; what is nearer may show
// any, and this one only by chance.
double covered_rather_than_tilted(const FaceSize& seen, double whole_mm) {
  const double size_spread = std::hypot(seen.size_mm.spread, learned_spread);
  const double area_spread = std::hypot(seen.area_mm2.spread, 2 * learned_spread);
  const double tilted = unlikely(seen.area_mm2.value / squared(whole_mm) - 1, area_spread) +
                        unlikely(1 - seen.size_mm.value / whole_mm, size_spread);
  return std::clamp(tilted - std::min(by_chance + 1, unlikely(seen.tilt_deviations, 1)) + 1, 0.0, 1.0);
}

// How far off where it is narrower than it is from the front, so that it is turned or covered.
double by_narrowing_px(const FaceSize& seen, const SeenMark& left, double whole_mm, double front) {
  const FaceSize now = if_not_tilted(seen);
  const double shown = front < least_round ? 1 : front;
  const Narrowed if_covered = narrowed(shown, shown, now, left);
  const double size_spread = std::hypot(now.size_mm.spread, learned_spread);
  const double area_spread = std::hypot(now.area_mm2.spread, 2 * learned_spread);
  const double apart_spread =
      motion_by_strip * std::numbers::sqrt2 * centre_spread_px(left, left.noise) / now.disparity_px;
  const double too_small = 1 - now.size_mm.value / whole_mm;
  const double turned = unlikely(seen.area_mm2.value / squared(whole_mm) - 1, area_spread) +
                        unlikely(1 - seen.size_mm.value / whole_mm, size_spread);
  const double by_what_is_as_far =
      unlikely(now.area_mm2.value / squared(whole_mm) - std::min(1.0, now.left_shown), area_spread) +
      unlikely(too_small, size_spread);
  const double by_what_is_nearer = unlikely(too_small - if_covered.too_small, std::hypot(size_spread, apart_spread));
  const double covered = std::max(turned - by_what_is_as_far, turned - by_what_is_nearer - by_chance);
  return std::clamp(covered, 0.0, 1.0) * if_covered.off_px;
}

// How much larger it should look, as a part of how it does; nothing where it looks as large as it was learned. Not of
// the likest sample: as near as it was in any it may be now.
double larger_when_learned(const LearnedObject& object, const SeenMark& mark) {
  double least_scale = 1;
  for (const LearnedSample& sample : object.samples) {
    if (is_triangle(sample.outlines.front())) least_scale = std::min(least_scale, spread_scale_of(mark, sample));
  }
  return 1 / least_scale - 1;
}

}  // namespace

double may_be_off_by_size_px(const LearnedObject& object, const SeenMark& mark) {
  const double longer_px = std::sqrt(spread_product_px2(mark) / mark.slimness);
  return motion_by_corner * larger_when_learned(object, mark) * longer_px;
}

double may_be_off_by_learned_px(const LearnedObject& object, const SeenMark& mark) {
  return std::max(may_be_off_by_shape_px(mark, front_slimness(object)), may_be_off_by_size_px(object, mark));
}

double may_be_off_by_learned_px(const LearnedObject& object, const FaceSize& seen, const SeenMark& left) {
  const auto unknown = [](const LearnedSample& sample) { return sample.most_face_mm() <= 0; };
  if (std::ranges::any_of(object.samples, unknown)) return may_be_off_by_learned_px(object, left);
  const double front = front_slimness(object);
  const FaceSize now = if_not_tilted(seen);
  const double spread = std::hypot(now.size_mm.spread, learned_spread);
  const double whole = whole_mm(object, std::sqrt(now.area_mm2.value), spread);
  // How a slim mark lies and how it is tilted are not told apart well enough.
  const double covered = front < least_round ? 1 : covered_rather_than_tilted(seen, whole);
  const double by_loss = covered * by_loss_px(now, left, whole);
  return std::max(by_loss, by_narrowing_px(seen, left, whole, front));
}

}  // namespace pizarra::vision
