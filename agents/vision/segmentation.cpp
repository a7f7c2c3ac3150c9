#include "agents/vision/segmentation.hpp"

#include <cassert>
#include <opencv2/imgproc.hpp>

namespace pizarra {
namespace {

// Half the image's size is enough to see how dark and light it gets; the window must reach past the largest mark's
// edge from its middle.
constexpr int window_half_px = 25;
constexpr int least_local_contrast = 30;

}  // namespace

ImageSegmentation::ImageSegmentation(cv::Mat grey) : grey_(std::move(grey)) {
  assert(grey_.type() == CV_8UC1);
  cv::Mat half;
  cv::resize(grey_, half, {}, 0.5, 0.5, cv::INTER_AREA);
  const cv::Mat window = cv::getStructuringElement(cv::MORPH_RECT, {window_half_px, window_half_px});
  cv::Mat lowest;
  cv::Mat highest;
  cv::erode(half, lowest, window);
  cv::dilate(half, highest, window);
  cv::Mat middle;
  cv::addWeighted(lowest, 0.5, highest, 0.5, 0, middle);
  cv::Mat contrast = highest - lowest;
  cv::blur(middle, middle, {9, 9});
  cv::resize(middle, middle, grey_.size(), 0, 0, cv::INTER_LINEAR);
  cv::resize(contrast, contrast, grey_.size(), 0, 0, cv::INTER_NEAREST);
  const cv::Mat structured = contrast >= least_local_contrast;
  cv::compare(grey_, middle, dark_, cv::CMP_LT);
  cv::bitwise_not(dark_, light_);
  cv::bitwise_and(dark_, structured, dark_);
  cv::bitwise_and(light_, structured, light_);
}

const std::vector<SeenMark>& ImageSegmentation::marks() {
  if (!collected_) {
    collected_ = true;
    collect(MarkTone::dark);
    collect(MarkTone::light);
  }
  return marks_;
}

void ImageSegmentation::collect(MarkTone tone) {
  std::vector<MarkContour> contours;
  std::vector<cv::Vec4i> families;
  cv::findContours(mask(tone), contours, families, cv::RETR_CCOMP, cv::CHAIN_APPROX_NONE);
  for (std::size_t i = 0; i < contours.size() && marks_.size() < most_marks; ++i) {
    const MarkContour& contour = contours[i];
    const bool is_hole = families[i][3] >= 0;
    if (is_hole || contour.size() > longest_contour_px) continue;
    const cv::Rect box = cv::boundingRect(contour);
    const double area = cv::contourArea(contour) + static_cast<double>(contour.size()) / 2;
    if (area < least_mark_area_px || area > largest_mark_area_px) continue;
    if (5 * area < box.area() || box.width > 4 * box.height || box.height > 4 * box.width) continue;
    std::optional<SeenMark> mark = measure_mark(grey_, contour, tone);
    if (mark) marks_.push_back(std::move(*mark));
  }
}

}  // namespace pizarra
