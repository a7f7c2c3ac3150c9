#pragma once

// How much of a mark that one camera alone follows may be covered. A face that is turned and one that something slowly
// slides over are the same to it: both look narrower than they did. So it remembers the widest look, and is the
// less sure the farther off the centre would be if all that is missing of it were covered.
//
//   WidestLook widest;
//   widest.follow(first);               // what is taken for the mark
//   const double off = widest.off_if_covered_px(now);
//
// A mark that is smaller to all sides is farther away. A triangle may be covered instead: a cover along one of its
// sides leaves a triangle. The memory only grows: a hand may rest.

#include <array>
#include <optional>

#include "agents/vision/marks/mark_measure.hpp"

namespace pizarra::vision {

class WidestLook {
 public:
  // How far the centre may be off if all that is missing were covered.
  double off_if_covered_px(const SeenMark& now) const;
  void follow(const SeenMark& now);

 private:
  // Standard deviations along x, y and both diagonals, px.
  using Spreads = std::array<double, 4>;
  static Spreads spreads_of(const SeenMark& mark);

  std::optional<Spreads> widest_;  // none before the first look
  bool triangle_ = false;
};

}  // namespace pizarra::vision
