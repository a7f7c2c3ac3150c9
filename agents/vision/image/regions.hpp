#pragma once

// The connected regions of a bit image, in one pass over its runs: eight neighbours connect.
//
//   for (const Region& region : regions_of(bits)) if (region.area_px > 60) follow_contour(bits, region.start, 400);

#include <opencv2/core.hpp>
#include <vector>

#include "agents/vision/image/bit_rows.hpp"

namespace pizarra::vision {

struct Region {
  int area_px = 0;
  cv::Rect box;
  cv::Point start;  // of its pixels the uppermost, of these the first: the pixel left of it is outside
};

// In the order of their starts, row by row.
std::vector<Region> regions_of(const BitImage& bits);

}  // namespace pizarra::vision
