#include "agents/vision/agent/grey_pair.hpp"

#include <opencv2/imgproc.hpp>

namespace pizarra::vision {
namespace {

// Shares the pixels of what is grey already.
cv::Mat grey(const Image& image) {
  cv::Mat view(image.height, image.width, CV_8UC(image.channels), const_cast<std::uint8_t*>(image.pixels.data()));
  if (image.channels == 3) cv::cvtColor(view, view, cv::COLOR_BGR2GRAY);
  return view;
}

}  // namespace

GreyPair grey_pair(const camera::StereoFrame& frame) { return {grey(*frame.left), grey(*frame.right)}; }

std::shared_ptr<const Image> grey_image(const std::shared_ptr<const Image>& image) {
  if (image->channels == 1) return image;
  const cv::Mat view = grey(*image);
  return std::make_shared<Image>(Image{image->width, image->height, 1, {view.datastart, view.dataend}});
}

}  // namespace pizarra::vision
