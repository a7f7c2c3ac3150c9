#pragma once

// Whether a tag's corners are where its cells say. A cover along its border leaves a smaller square, in which the cells
// can still be read. They are then not where the corners put them.
//
//   const double off = middle_off_px(grey, corners, family, 17);

#include "agents/vision/marks/tag_detection.hpp"

namespace pizarra::vision {

// How far the middle of the tag's corners would move if they went where the edges of its cells put them, to first
// order: as it is to some 15 %, up to half a cell. The corners begin with the tag's own upper left one, clockwise.
double middle_off_px(const cv::Mat1b& grey, const TagCorners& corners, const TagFamily& family, int number);

// So little that it does not matter where it comes from.
inline constexpr double hardly_off_px = 0.25;

// The corners where the edges of its cells put them, to first order.
TagCorners fitted_corners(const cv::Mat1b& grey, const TagCorners& corners, const TagFamily& family, int number);

}  // namespace pizarra::vision
