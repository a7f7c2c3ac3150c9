#pragma once

// The place that a person clicked on: the area that is filled from there, and the mark or the tag that this is, or why
// it is none.
//
//   ClickedPlace place(grey, {160, 120});          // within the image
//   place.filled();                                // for the picture
//   Result<SeenMark> mark = place.mark();
//
// Failures: background, open-contour, border, too-small, too-large, unclear-tag.

#include "agents/vision/marks/segmentation.hpp"
#include "lisp/result.hpp"

namespace pizarra::vision {

class ClickedPlace {
 public:
  ClickedPlace(const cv::Mat& grey, cv::Point2d click);

  // 255, of the image's size; nothing where the place has no tone.
  const cv::Mat1b& filled() const { return filled_; }
  Result<SeenMark> mark();

 private:
  void fill();
  cv::Mat1b unlike() const;
  Result<SeenMark> solid_mark();
  std::optional<SeenMark> mark_around();
  std::unexpected<Failure> why_none() const;
  bool stands_out() const;
  std::unexpected<Failure> refuse(const char* symbol, const char* sentence) const;

  cv::Mat grey_;
  cv::Point2d click_;
  cv::Point seed_;
  ImageSegmentation segmentation_;
  cv::Mat1b filled_;
  MarkTone tone_ = MarkTone::dark;  // of what is filled
  int other_px_ = 0;                // what it encloses that is unlike it
};

}  // namespace pizarra::vision
