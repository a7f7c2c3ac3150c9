#pragma once

// The closed regions of an image that are darker, or lighter, than all around them, whatever the light there: those of
// many thresholds, each region once (J. Matas et al., Robust wide-baseline stereo from maximally stable extremal
// regions, BMVC 2002). So a shadow's edge across a sheet parts no mark from its outline, as one threshold for both
// sides of it would.
//
//   for (const LevelRegion& region : level_regions(pixels, MarkTone::dark)) region.contour, region.reach ...

#include "agents/vision/marks/mark_patch.hpp"
#include "agents/vision/marks/plane_outline.hpp"

namespace pizarra::vision {

struct LevelRegion {
  MarkContour contour;
  cv::Rect box;
  Reach reach;  // of its contour, px
};

inline constexpr std::size_t most_level_regions = 512;  // the largest of them

// In all of the pixels, or within `area` alone, as if the image ended there.
std::vector<LevelRegion> level_regions(const cv::Mat1b& pixels, MarkTone tone);
std::vector<LevelRegion> level_regions(const cv::Mat1b& pixels, MarkTone tone, const cv::Rect& area);

}  // namespace pizarra::vision
