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
  double goes_on = 0;       // of what is hidden: ink lies on both sides, as where it is an arm of something larger
  double filled = 0;        // of the places that support it: there is ink deeper inside as well
  double rms_px = 0;        // of the places that support it
  double supported_px = 0;  // how long they are together
  double ink = 0;           // grey levels, as most of them show them
  double ground = 0;
  double ratio = 0;   // how many times as light the lighter one is
  double uneven = 0;  // how much either scatters, as a part of the contrast: a standard deviation
};

// Edges that are not the mark's border stop being it (PlaneEdge::is_border).
SeenPart judge_part(const ImageCut& cut, const PlaneOutline& outline, PlaneFit& fit, MarkTone tone);

}  // namespace pizarra::vision
