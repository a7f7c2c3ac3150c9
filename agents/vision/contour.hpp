#pragma once

// Closed contours in a binary image (255 inside, 0 outside), followed pixel by pixel.
//
//   std::optional<MarkContour> contour = follow_contour(mask, start, 400);
//   std::optional<MarkContour> tracked = contour_from_centre(mask, last_centre, 12, 400);

#include <opencv2/core.hpp>
#include <optional>
#include <vector>

namespace pizarra {

using MarkContour = std::vector<cv::Point>;  // the region's border pixels, px, 8-connected, in order

// Follows the outer border of the region that `start` belongs to; the pixel left of `start` is outside. Nothing when it
// is longer than `max_points`, or runs along the image's edge (it is open there).
std::optional<MarkContour> follow_contour(const cv::Mat& mask, cv::Point start, std::size_t max_points);

// The interline method: looks for an inside pixel within `reach_px` of `centre`, goes left along its line to the border
// and follows that. Nothing when there is none, or the border found is that of a hole.
std::optional<MarkContour> contour_from_centre(const cv::Mat& mask, cv::Point centre, int reach_px,
                                               std::size_t max_points);

}  // namespace pizarra
