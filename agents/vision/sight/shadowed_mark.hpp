#pragma once

// A followed mark with a shadow's edge across it: no one level of its ground holds all around it, so its outline is
// registered edge by edge, where the mark should be. A cover over a part of it makes the ground uneven as well. So the
// look is taken for the mark in two cases: the print beside the outline shows that light made the ground uneven, or the
// mark lies just as it did in even light.
//
//   std::optional<LitMark> lit = LitMark::of(seen);      // each look in even light
//   std::optional<SeenPair> now = find_in_shadow(sight, objects, object, last, expected, lit);

#include "agents/vision/sight/stereo_sight.hpp"

namespace pizarra::vision {

// Where a mark was in even light, and how large.
struct LitMark {
  cv::Point2d centre;
  double width_px;
  double height_px;

  // Nothing of one that was found in a shadow.
  static std::optional<LitMark> of(const SeenMark& mark);
  // Whether it rests there, and nothing hides a part of it that would put its centre off by a pixel.
  bool is(const SeenMark& now) const;
};

// The object about where it is expected, as large about as `last`, in both images; no tag.
std::optional<SeenPair> find_in_shadow(StereoSight& sight, const LearnedObjects& objects, const LearnedObject& object,
                                       const SeenMark& last, cv::Point2d expected, const std::optional<LitMark>& lit);

}  // namespace pizarra::vision
