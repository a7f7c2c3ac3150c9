#pragma once

// One image and the closed regions of either tone in it that could be marks. The inside of a large mark, where nothing
// but the mark is nearby, has no tone: such a mark is a closed band along its border.
//
//   ImageSegmentation segmentation(grey);
//   for (const SeenMark& mark : segmentation.marks()) ...

#include <optional>
#include <vector>

#include "agents/vision/image/look.hpp"
#include "agents/vision/image/tone_split.hpp"
#include "agents/vision/marks/mark_measure.hpp"

namespace pizarra::vision {

inline constexpr int least_mark_area_px = 60;  // to be learned
inline constexpr int least_seen_area_px = 50;  // to be found, farther away
inline constexpr std::size_t most_marks = 128;
// A mark is at most nine tenths of the image wide and high: ground must be seen around it.
bool is_too_large_for_a_mark(cv::Size box, cv::Size image);
std::size_t longest_contour_px(cv::Size image);

class ImageSegmentation {
 public:
  // `grey`: 8 bit, one channel; it may be shared, not copied. `focal_px`: of its camera, where that is known. Only
  // regions within `area` that do not reach its border are told; these are the same as in the whole image.
  ImageSegmentation(const cv::Mat& grey, double noise, double focal_px = 0, std::optional<cv::Rect> area = {});
  explicit ImageSegmentation(const cv::Mat& grey) : ImageSegmentation(grey, noise_of(grey)) {}

  // As the eyes look at it.
  const ImageCut& cut() const { return cut_; }
  const cv::Mat1b& image() const { return cut_.pixels; }
  // What is looked at of it.
  const cv::Rect& area() const { return area_; }
  const BitImage& bits(MarkTone tone) const { return tone == MarkTone::dark ? split_.dark : split_.light; }
  // 255 where the image has that tone.
  cv::Mat1b mask(MarkTone tone) const;
  // Every closed region that measures as a mark, dark ones first; where there may be more than most_marks the largest,
  // these first, of either tone. Computed once.
  const std::vector<SeenMark>& marks();
  // How many smaller regions were not looked at, as there were most_marks already; after marks().
  std::size_t left_out() const { return left_out_; }

 private:
  struct Candidate;
  std::vector<Candidate> candidates() const;
  double focal_px_;
  cv::Rect area_;
  ImageCut cut_;
  ToneSplit split_;
  bool collected_ = false;
  std::vector<SeenMark> marks_;
  std::size_t left_out_ = 0;
};

}  // namespace pizarra::vision
