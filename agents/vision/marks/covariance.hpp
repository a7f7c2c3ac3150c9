#pragma once

// The symmetric square root of a 2x2 covariance S: (S + sqrt(det S) I) / sqrt(trace S + 2 sqrt(det S)). It leads from a
// circle of one standard deviation to the ellipse that has this covariance.
//
//   const cv::Matx22d spread = root_of({xx, xy, xy, yy});

#include <cmath>
#include <opencv2/core.hpp>

namespace pizarra::vision {

inline cv::Matx22d root_of(const cv::Matx22d& covariance) {
  const double xx = covariance(0, 0);
  const double xy = covariance(0, 1);
  const double yy = covariance(1, 1);
  const double root = std::sqrt(xx * yy - xy * xy);
  const double scale = 1 / std::sqrt(xx + yy + 2 * root);
  return {(xx + root) * scale, xy * scale, xy * scale, (yy + root) * scale};
}

}  // namespace pizarra::vision
