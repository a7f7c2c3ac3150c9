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
  const cv::Mat1b& regions = mask(tone);
  cv::Mat1i labels;
  cv::Mat1i stats;
  cv::Mat1d centroids;
  const int count = cv::connectedComponentsWithStats(regions, labels, stats, centroids, 8, CV_32S);
  for (int label = 1; label < count && marks_.size() < most_marks; ++label) {
    const int area = stats(label, cv::CC_STAT_AREA);
    const int left = stats(label, cv::CC_STAT_LEFT);
    const int top = stats(label, cv::CC_STAT_TOP);
    const int width = stats(label, cv::CC_STAT_WIDTH);
    const int height = stats(label, cv::CC_STAT_HEIGHT);
    if (area < least_mark_area_px || area > largest_mark_area_px) continue;
    if (5 * area < width * height || width > 4 * height || height > 4 * width) continue;
    const int* row = labels.ptr<int>(top);
    int x = left;
    while (row[x] != label) ++x;
    const std::optional<MarkContour> contour = follow_contour(regions, {x, top}, longest_contour_px);
    if (!contour) continue;
    std::optional<SeenMark> mark = measure_mark(grey_, *contour, tone);
    if (mark) marks_.push_back(std::move(*mark));
  }
}

}  // namespace pizarra
