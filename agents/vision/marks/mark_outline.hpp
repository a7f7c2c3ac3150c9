#pragma once

// The outline of a mark as waves around its centre: how far it reaches in each direction, once place, size, turn and
// slant are undone (mark_signature.hpp). Noise puts a little into every wave, another shape much into a few: so a
// hexagon and a circle differ, whose pictures differ by hardly more than noise makes.
//
//   outline_difference(outline_of(seen.signature), outline_of(learned.signature), 0.5).in_all;      // 0 alike

#include <array>

#include "agents/vision/marks/mark_signature.hpp"

namespace pizarra::vision {

// Amplitudes, in standard deviations of the mark. Three waves to eight around it: one or two are its place and its
// slant, and of more the blur leaves little.
struct MarkOutline {
  static constexpr int first = 3;
  static constexpr int count = 6;
  std::array<float, count> cosines{};
  std::array<float, count> sines{};

  // The mean square of what is not round.
  double power() const;
};

MarkOutline outline_of(const MarkSignature& signature);

// Three corners are all of it: a straight edge along one of its sides leaves the same form.
bool is_triangle(const MarkOutline& outline);

// It looks the same after a third, a quarter or less of a whole turn, as a circle, a regular polygon and a star do. So
// does a rectangle's outline, whose stretch is undone here.
bool is_regular(const MarkOutline& outline);

// The difference between the waves of a seen outline and those of the learned one, which is turned, and blurred by at
// most `most_blur` standard deviations, as fits best. Mean squares, in standard deviations squared. Noise is in all
// waves; an unlearned shape may differ by one of them alone.
struct OutlineDifference {
  double in_all = 0;
  double in_one = 0;  // the greatest
};
OutlineDifference outline_difference(const MarkOutline& seen, const MarkOutline& learned, double most_blur);

}  // namespace pizarra::vision
