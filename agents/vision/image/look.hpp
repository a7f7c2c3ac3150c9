#pragma once

// How the eyes look at an image. A quiet image is used as it is, a noisy one is smoothed. That takes five eighths of a
// sensor's noise away. It moves no centre, but widens marks a little, and unevenly, by the pixels' phase.
//
//   const double noise = noise_of(grey);
//   ImageCut all = look_at(grey, {0, 0, grey.cols, grey.rows}, noise);
//   ImageCut part = look_at(grey, around, noise);     // pixel (x, y) of `part` is x + part.origin.x, ... of `grey`

#include <opencv2/core.hpp>

namespace pizarra::vision {

struct ImageCut {
  cv::Mat1b pixels;  // shared with the image, or its own
  cv::Point origin;
  double noise;  // what is left of it
};

// The sensor's noise, as a standard deviation in grey levels: the median over some rows.
double noise_of(const cv::Mat& grey);

// `area` lies within `grey`, which has 8 bits and one channel. Smoothed by binomial weights, 1 2 1 along and across,
// every result rounded up a little, all alike; what lies beyond the image's edge is as the edge.
ImageCut look_at(const cv::Mat& grey, cv::Rect area, double noise);

}  // namespace pizarra::vision
