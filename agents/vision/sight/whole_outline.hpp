#pragma once

// Whether the registered outline of a mark says that the mark is whole. A straight edge that hides a part of a form
// that shows cuts (cut_outline.hpp) leaves edges that are off together, or none.
//
//   view.shows_all = shows_all({sample, left_fit, right_fit, pose, by_both}, px_in(sight.left(), 1));

#include "agents/vision/sight/plane_view.hpp"

namespace pizarra::vision {

struct RegisteredOutline {
  const LearnedSample& sample;
  const PlaneFit& left;
  const PlaneFit* right;  // where the right image shows it
  const PlanePose& pose;
  bool right_shows_mark;  // then its outline must be registered there too
};

// `most_off_px`: how far off a centre may be that is told surely. Always false of a form that shows no cuts.
bool shows_all(const RegisteredOutline& seen, double most_off_px);

}  // namespace pizarra::vision
