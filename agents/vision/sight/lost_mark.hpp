#pragma once

// Where a tracked mark is that is not followed any more, or not yet: about where it is expected, in a shadow there, or
// anywhere. A mark like it that stood elsewhere when it was seen last is another one, and is left out.
//
//   std::optional<SeenPair> now = find_lost(sight, track, objects, object, captured);
//
// It may be turned so far away that its picture is not like it. Its outline is: that is registered with every region,
// which takes some 4 ms where a look at the regions takes 0.1. So it is not done in every frame once the mark has been
// lost for longer.

#include "agents/vision/sight/tracked_mark.hpp"

namespace pizarra::vision {

// How far a mark moves from one frame to the next, at most, where its motion is known from these.
double most_step_px(const StereoSight& sight);

// Whether it is whole is another matter.
std::optional<SeenPair> find_lost(StereoSight& sight, TrackedMark& track, const LearnedObjects& objects,
                                  const LearnedObject& object, Time captured);

}  // namespace pizarra::vision
