#pragma once

// A seen mark as its learned object's plane shows it: the perspective and the light of each part of it undone, so that
// what is left to compare is the shape.
//
//   std::optional<SeenMark> mark = seen_in_plane(cut, sample, region);
//   if (mark && is_recognised(*mark, objects, object)) ...

#include "agents/vision/marks/level_regions.hpp"
#include "agents/vision/marks/plane_fit.hpp"
#include "agents/vision/objects/learned.hpp"

namespace pizarra::vision {

struct PlaneLook {
  SeenMark mark;
  PlaneFit fit;
};

// The sample's outline registered with the image, beginning with a region's; nothing where too little of it is there to
// be registered. Whether it is the sample's is another matter.
std::optional<PlaneFit> fit_region(const ImageCut& cut, const LearnedSample& sample, const Reach& region);

bool is_outline_of(const PlaneFit& fit);

// Where and how large the mark is by the fit of an outline with this middle: its centre, its standard deviations, its
// slimness.
void set_place(SeenMark& mark, const PlaneFit& fit, const cv::Vec2d& middle);

// As the sample's outline says that it looks, whatever region of the image shows it: its place, its area, and every
// pixel around it.
void set_outline(SeenMark& mark, const PlaneFit& fit, const LearnedSample& sample);

// Nothing where the region's outline is not that of the sample, however it is seen.
std::optional<PlaneLook> seen_in_plane(const ImageCut& cut, const LearnedSample& sample, const LevelRegion& region);

}  // namespace pizarra::vision
