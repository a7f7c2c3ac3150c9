#pragma once

// Where a stereo camera stands in a cell: as its cell file says it, its driver renders it and the coordinator looks
// through it.
//
//   CameraPose pose{.at_mm = {1330, 0, 200}};   // before the arm, looking at it

#include <array>

namespace pizarra::forms {

// The base line's centre in the base frame. The pair looks along the base's -x, turned by pan (positive: towards +y,
// image right) and then by tilt (positive: up).
struct CameraPose {
  std::array<double, 3> at_mm{1330, 0, 200};
  double pan_deg = 0;
  double tilt_deg = 0;
  bool operator==(const CameraPose&) const = default;
};

}  // namespace pizarra::forms
