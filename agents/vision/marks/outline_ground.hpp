#pragma once

// The ground around an outline that was registered with an image, and why it is uneven where it is. Light changes print
// and ground alike: a shadow's edge, a lamp's reflection. A thing that hides a part does not change the print
// beside it.
//
//   const OutlineGround ground = look_at_ground(cut, sample.plane, fit);
//   if (ground.doubt > 1 && ground.light < 0.1) ...       // something else than light: it may hide a part

#include "agents/vision/marks/plane_fit.hpp"

namespace pizarra::vision {

struct OutlineGround {
  // As ground_doubt() has it (mark_ground.hpp), beyond where each edge ends, however wide motion makes it.
  double doubt = 0;
  // How likely it is light that makes one side's ground differ, 0 to 1; little where nothing tells, and where
  // the ground is even.
  double light = 0;
};

OutlineGround look_at_ground(const ImageCut& cut, const PlaneOutline& outline, const PlaneFit& fit);

}  // namespace pizarra::vision
