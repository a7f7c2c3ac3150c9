#pragma once

// How much of a mark that one camera alone follows may be covered. A face that is turned and one that something slowly
// slides over are the same to it: both look narrower than they did. So it remembers the widest look, and is the
// less sure the farther off the centre would be if all that is missing of it were covered.
//
//   WidestLook widest;
//   widest.follow(first);               // what is taken for the mark
//   const double confidence = widest.confidence(0.99, now, 1);
//
// What is smaller to all sides is farther away, but of a triangle: what lies along one of its sides leaves a triangle.
// The memory only grows: a hand may rest.

#include <array>
#include <optional>

#include "agents/vision/marks/mark_measure.hpp"

namespace pizarra {

class WidestLook {
 public:
  // What is left of the confidence in a whole mark, where a centre that is told may be so far off: one half where it
  // may be just that.
  double confidence(double of_whole, const SeenMark& now, double most_off_px) const;
  void follow(const SeenMark& now);

 private:
  // Standard deviations along x, y and both diagonals, px.
  using Spreads = std::array<double, 4>;
  static Spreads spreads_of(const SeenMark& mark);
  double may_be_off_px(const SeenMark& now) const;

  std::optional<Spreads> widest_;  // none before the first look
  bool triangle_ = false;
};

}  // namespace pizarra
