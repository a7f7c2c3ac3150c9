#pragma once

// A learned mark of which an image shows a part: registered by what is seen of its outline, so that its middle and its
// pose are those of the whole (marks/seen_part.hpp).
//
//   for (const PartLook& look : look_for_parts(cut, edges, objects, circle, lens)) look.fit.in_image({0, 0}) ...
//
// Told where enough is supported, hardly anything contradicts it, and no other learned object explains more of the same
// edges: three sides of a cross's arm are most of a small square's.

#include "agents/vision/marks/edge_chains.hpp"
#include "agents/vision/marks/seen_part.hpp"
#include "agents/vision/objects/learned.hpp"

namespace pizarra::vision {

struct PartLook {
  const LearnedSample* sample;
  PlaneFit fit;
  SeenPart part;
};

// The one with the most support first. Without a focal length nothing tells how far the outline of a square reaches
// behind what hides a whole side.
std::vector<PartLook> look_for_parts(const ImageCut& cut, const EdgeChains& edges, const LearnedObjects& objects,
                                     const LearnedObject& object, const PlaneLens& lens);

// As the whole of it would look.
SeenMark whole_mark(const ImageCut& cut, const PartLook& look);

}  // namespace pizarra::vision
