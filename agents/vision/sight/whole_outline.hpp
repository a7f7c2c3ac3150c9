#pragma once

// How far off a mark's centre may be because a straight edge hides a part of the mark, by its registered outline. A
// cover's edge may be taken for the side that it hides. The other sides say where the mark's middle is then.
//
//   view.may_be_off_px = off_by_outline_px({sample, left_fit, right_fit, pose, by_both}, px_in(sight.left(), 1));
//
// The edges of one side after another are left out of the fit. The middle moves then, and is less sure: both say how
// far off it may be. Any form is asked so. A circle's other sides say it well, as do a square's before a pair. Before
// one camera the other sides of a square leave its tilt open.

#include "agents/vision/sight/plane_view.hpp"

namespace pizarra::vision {

struct RegisteredOutline {
  const LearnedSample& sample;
  const PlaneFit& left;
  const PlaneFit* right;  // where the right image shows it
  const PlanePose& pose;
  bool right_shows_mark;  // then its outline must be registered there too
};

// All around, and by edges that no straight one has bent.
bool is_registered(const PlaneOutline& outline, const PlaneFit& fit, double most_off_px);

// In the left image, about a standard deviation. Nothing where the outline is not registered all around, or is none of
// the mark's: then it says nothing. `most_off_px`: how far off a centre may be that is told surely.
std::optional<double> off_by_outline_px(const RegisteredOutline& seen, double most_off_px);

}  // namespace pizarra::vision
