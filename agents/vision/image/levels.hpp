#pragma once

// The grey level of an image at a place that is no whole pixel.
//
//   nearest_level(grey, {12.4, 7.9});       // that of the pixel there; outside, of the nearest one
//   level_between(grey, {12.4, 7.9});       // between its four neighbours, which must all be within the image

#include <algorithm>
#include <cstdint>
#include <opencv2/core.hpp>

namespace pizarra::vision {

inline double nearest_level(const cv::Mat1b& grey, const cv::Point2d& at) {
  const int x = std::clamp(cvRound(at.x), 0, grey.cols - 1);
  const int y = std::clamp(cvRound(at.y), 0, grey.rows - 1);
  return grey(y, x);
}

inline double level_between(const cv::Mat1b& grey, const cv::Point2d& at) {
  const int column = static_cast<int>(at.x);
  const int row = static_cast<int>(at.y);
  const double right = at.x - column;
  const double down = at.y - row;
  const std::uint8_t* above = grey.ptr<std::uint8_t>(row) + column;
  const std::uint8_t* below = above + grey.step;
  return (1 - down) * ((1 - right) * above[0] + right * above[1]) + down * ((1 - right) * below[0] + right * below[1]);
}

}  // namespace pizarra::vision
