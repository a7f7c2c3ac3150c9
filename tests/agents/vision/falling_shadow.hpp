#pragma once

// The edge of a shadow over a drawn image: beyond it there is less light.
//
//   Shadow{.from_deg = 90, .edge_px = -4, .light = 0.6}.fall(left, centre);

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>

namespace pizarra::vision {

struct Shadow {
  double from_deg;
  double edge_px;  // from the centre of what it falls on
  double light;    // the share that is left

  void fall(cv::Mat1b image, cv::Point2d centre) const {
    constexpr double soft_px = 3;
    const double from = from_deg * CV_PI / 180;
    for (int y = 0; y < image.rows; ++y) {
      for (int x = 0; x < image.cols; ++x) {
        const cv::Point2d off = cv::Point2d(x, y) - centre;
        const double beyond = off.x * std::cos(from) + off.y * std::sin(from) - edge_px;
        const double shaded = std::clamp(beyond / soft_px + 0.5, 0.0, 1.0);
        image(y, x) = cv::saturate_cast<std::uint8_t>(image(y, x) * (1 - (1 - light) * shaded));
      }
    }
  }
};

}  // namespace pizarra::vision
