#pragma once

// One image divided into what is dark and what is light around each pixel, and the closed regions of either tone that
// could be marks. The threshold is local, halfway between the darkest and the lightest nearby, so that a light gradient
// does not matter; where there is no contrast nearby, a pixel is neither.
//
//   ImageSegmentation segmentation(grey);
//   for (const SeenMark& mark : segmentation.marks()) ...

#include <vector>

#include "agents/vision/mark_measure.hpp"

namespace pizarra {

inline constexpr int least_mark_area_px = 60;
inline constexpr int largest_mark_area_px = 2500;
inline constexpr std::size_t longest_contour_px = 400;
inline constexpr std::size_t most_marks = 128;

class ImageSegmentation {
 public:
  // `grey`: 8 bit, one channel; it is shared, not copied.
  explicit ImageSegmentation(cv::Mat grey);

  const cv::Mat& grey() const { return grey_; }
  // 255 where the image has that tone.
  const cv::Mat1b& mask(MarkTone tone) const { return tone == MarkTone::dark ? dark_ : light_; }
  // Every closed region that measures as a mark, dark ones first; at most most_marks. Computed once.
  const std::vector<SeenMark>& marks();

 private:
  void collect(MarkTone tone);
  cv::Mat grey_;
  cv::Mat1b dark_;
  cv::Mat1b light_;
  bool collected_ = false;
  std::vector<SeenMark> marks_;
};

}  // namespace pizarra
