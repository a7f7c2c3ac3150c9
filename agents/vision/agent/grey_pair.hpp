#pragma once

// Grey images of a frame, as all that the eyes do with it needs them. They share its pixels where these are grey
// already.
//
//   const GreyPair grey = grey_pair(frame);
//   StereoSight sight(grey.left, grey.right, model);

#include <opencv2/core.hpp>

#include "drivers/camera/stereo_camera.hpp"

namespace pizarra::vision {

struct GreyPair {
  cv::Mat left;
  cv::Mat right;
};

GreyPair grey_pair(const camera::StereoFrame& frame);
std::shared_ptr<const Image> grey_image(const std::shared_ptr<const Image>& image);

}  // namespace pizarra::vision
