#pragma once

// How much of a triangle that one camera alone follows may be covered. A cover along one of its sides leaves a
// triangle, which looks like the whole one farther away. So the nearest look is remembered, and the triangle is the
// less sure the farther off its middle would be if it were covered since.
//
//   NearestLook nearest;
//   const double off_px = nearest.off_if_covered_px(sample.plane, fit, range_mm, goes_on);   // in each frame
//
// A cover's edge does not turn with the mark. Where all sides turn in the image while it looks farther away, it is.

#include <optional>
#include <vector>

#include "agents/vision/marks/plane_fit.hpp"

namespace pizarra::vision {

class NearestLook {
 public:
  // By this look, which is remembered. `goes_on`: from the last frame's outline, so that each side is the same one.
  double off_if_covered_px(const PlaneOutline& outline, const PlaneFit& fit, double range_mm, bool goes_on);

 private:
  std::optional<double> nearest_mm_;  // none before the first look
  std::vector<double> directions_;    // of the sides in the image, since it looks farther away
};

}  // namespace pizarra::vision
