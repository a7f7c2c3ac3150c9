#pragma once

// Judges each place of an outline that was registered with an image: the image shows the mark's border there, it
// shows that there is none, or something hides it.
//
//   const SeenPart part = judge_part(cut, outline, fit, MarkTone::dark);
//   part.supported, part.contradicted, part.hidden       // they add up to 1
//
// A place supports the mark where ink goes over into ground, each as light as most of it. It contradicts the mark where
// both sides are ground, or the border lies elsewhere. Everywhere else the mark is hidden, also by the edge of a
// shadow.

#include "agents/vision/marks/plane_fit.hpp"

namespace pizarra::vision {

struct SeenPart {
  double supported = 0;
  double contradicted = 0;
  double hidden = 0;
  double rms_px = 0;        // of the places that support it
  double supported_px = 0;  // how long they are together
};

// Edges that are not the mark's border stop being it (PlaneEdge::is_border).
SeenPart judge_part(const ImageCut& cut, const PlaneOutline& outline, PlaneFit& fit, MarkTone tone);

}  // namespace pizarra::vision
