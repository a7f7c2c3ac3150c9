#pragma once

// How large a mark would look if its face were not yawed, as one image tells it. A yaw squeezes a mark along x. So the
// mark's slimness is compared with its slimness from the front, whichever way it is turned in the image.
//
//   const Unyawed look = unyawed(mark, front_slimness(object));
//   const double depth_mm = focal_px * size_mm / look.size_px;

#include "agents/vision/marks/mark_measure.hpp"

namespace pizarra::vision {

struct Unyawed {
  double size_px;  // the root of the product of both principal standard deviations
  double shown;    // how much of the width that it would have is to be seen
  double spread;   // how far the size may be off besides, as a part of it: a standard deviation
};

// `shown_height`: what of the height a tilt of the face shows (FacePlane::shown_height).
Unyawed unyawed(const SeenMark& mark, double front_slimness, double shown_height = 1);

}  // namespace pizarra::vision
