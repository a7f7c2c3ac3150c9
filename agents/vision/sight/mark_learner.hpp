#pragma once

// Learns a mark from a click: ten frames are averaged while the region around the clicked point is filled, then its
// contour is followed and measured in ten more. Where the point lies in a tag, it is the tag that is learned.
//
//   MarkLearner learner("circle", {160, 120}, objects);
//   while (!learner.done()) {
//     Result<void> fed = learner.feed(sight);     // failures say what is wrong with the place or the mark
//     if (!fed) return fail(fed);
//   }
//   LearnedSample sample = learner.sample();

#include "agents/vision/sight/stereo_sight.hpp"

namespace pizarra {

class MarkLearner {
 public:
  static constexpr int frames_per_step = 10;

  // `objects` outlives it.
  MarkLearner(std::string name, cv::Point2d click, const LearnedObjects& objects)
      : name_(std::move(name)), click_(click), objects_(objects) {}

  // Failures: outside, background, open-contour, border, too-small, too-large, moved, crowded, ambiguous, other-kind,
  // unclear-tag, wrong-size.
  Result<void> feed(StereoSight& sight);
  bool done() const { return filled_frames_ == frames_per_step && contour_frames_ == frames_per_step; }
  // After done().
  LearnedSample sample() const;

  // For the picture: what is filled now (255, image size; empty before the first frame) and the contour, once known.
  const cv::Mat1b& filled() const { return filled_; }
  const MarkContour& contour() const { return contour_; }

 private:
  Result<void> fill(const cv::Mat& left);
  void fill(const ImageSegmentation& mean, cv::Point seed);
  Result<void> check_region(const ImageSegmentation& mean);
  bool is_within_a_mark(ImageSegmentation& mean);
  Result<void> check_kind() const;
  Result<void> measure(StereoSight& sight);
  void measure_tag(StereoSight& sight);
  Result<void> check_measured() const;

  std::string name_;
  cv::Point2d click_;
  const LearnedObjects& objects_;
  int filled_frames_ = 0;
  int contour_frames_ = 0;
  cv::Mat1f sum_;
  cv::Mat1b filled_;
  MarkTone tone_ = MarkTone::dark;  // of what is filled
  int other_px_ = 0;                // what it encloses that is unlike it
  MarkContour contour_;
  std::optional<SeenMark> first_;  // on the averaged image
  std::vector<SeenMark> measured_;
  std::vector<MarkPortrait> portraits_;  // of the same
  std::vector<double> sizes_mm_;
  bool size_guessed_ = false;
  bool crowded_ = false;  // in a frame in which it was not measured, more regions were there than are looked at
};

}  // namespace pizarra
