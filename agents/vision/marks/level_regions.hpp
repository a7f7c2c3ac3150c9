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

// How many grey levels lie between two thresholds at most. A lamp's reflection adds as much to print and paper, so that
// few thresholds lie between them where each is a part above the one before. More of them show more covers as well.
struct LevelSteps {
  double most = 255;
};
inline constexpr LevelSteps fine_steps{20};

// In all of the pixels, or within `area` alone, as if the image ended there.
std::vector<LevelRegion> level_regions(const cv::Mat1b& pixels, MarkTone tone, const LevelSteps& steps = {});
std::vector<LevelRegion> level_regions(const cv::Mat1b& pixels, MarkTone tone, const cv::Rect& area,
                                       const LevelSteps& steps = {});

}  // namespace pizarra::vision
