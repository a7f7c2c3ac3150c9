#pragma once

// Learns a mark from a click: it is filled in ten frames, averaged while it rests, then its contour is measured in ten
// more. Where the point lies in a tag, it is the tag that is learned. The camera may be in a hand: the mark is followed
// from frame to frame, and what is learned is what the frames agree on.
//
//   MarkLearner learner("circle", {160, 120}, objects);
//   while (!learner.done()) {
//     Result<void> fed = learner.feed(sight);     // failures say what is wrong with the place or the mark
//     if (!fed) return fail(fed);
//   }
//   LearnedSample sample = learner.sample();

#include "agents/vision/sight/clicked_place.hpp"
#include "agents/vision/sight/face_plane.hpp"
#include "agents/vision/sight/hand_held_marks.hpp"
#include "agents/vision/sight/stereo_sight.hpp"

namespace pizarra::vision {

class MarkLearner {
 public:
  static constexpr int frames_per_step = 10;

  // `objects` outlives it.
  MarkLearner(std::string name, cv::Point2d click, const LearnedObjects& objects)
      : name_(std::move(name)), click_(click), objects_(objects) {}

  // Failures: outside, those of a ClickedPlace, moved, crowded, ambiguous, other-kind, wrong-size.
  Result<void> feed(StereoSight& sight);
  bool done() const { return filled_frames_ == frames_per_step && contour_frames_ == frames_per_step; }
  // After done().
  LearnedSample sample() const;

  // For the picture: what is filled so far (255, image size; empty before the first frame), from the click outwards,
  // all of it in the tenth frame; and the contour, once known.
  cv::Mat1b filled_so_far() const;
  const MarkContour& contour() const { return contour_; }

 private:
  Result<void> fill(StereoSight& sight);
  void add_up(const cv::Mat& left);
  void begin_following(StereoSight& sight, const SeenMark& mark);
  std::vector<SeenMark> marks_in(StereoSight& sight) const;
  // Whether the mark is seen in this frame, and could be no other.
  bool follow(StereoSight& sight);
  // Measures the mean of the frames, where the last frame is one of those that are averaged.
  Result<void> end_filling(StereoSight& sight, const Result<SeenMark>& mark);
  Result<void> end_filling();
  Result<void> check_kind() const;
  Result<void> measure(StereoSight& sight);
  // How the picture of a shape is seen in one frame. Of each of `measured_`, but for tags.
  struct Portrayed {
    cv::Mat1b pixels;
    cv::Matx33d from_picture;             // about
    std::optional<FacePlane> plane = {};  // where both images show it
  };
  void look_from_front(StereoSight& sight, const SeenMark& seen);
  std::optional<FrontView> front_of(const std::optional<FacePlane>& plane, const cv::Matx22d& to_image) const;
  static std::optional<cv::Matx22d> registered(const LearnedSample& sample, const Portrayed& frame);
  std::vector<FrontView> fronts_by_outline(const LearnedSample& sample) const;
  Result<void> check_seen(std::size_t frames) const;
  Result<void> check_measured() const;
  cv::Mat1f mean_picture() const;

  std::string name_;
  cv::Point2d click_;  // where it would be in the frame in which the mark was seen last
  const LearnedObjects& objects_;
  int filled_frames_ = 0;
  int contour_frames_ = 0;
  cv::Mat1b first_frame_;  // where it showed no mark
  cv::Mat1w sum_;
  int summed_ = 0;
  cv::Point2d summed_at_;  // where the mark was then
  cv::Mat1b filled_;
  MarkContour contour_;
  std::optional<SeenMark> mark_;  // as it was seen last
  MarkedImage before_;            // that frame
  std::size_t seen_ = 0;          // in so many frames
  bool moved_ = false;
  bool ambiguous_ = false;  // in a frame it might have been another
  bool crowded_ = false;    // in one in which it was not seen, more regions were there than are looked at
  std::vector<SeenMark> measured_;
  std::vector<MarkPortrait> portraits_;  // of the same
  std::vector<FrontView> fronts_;        // of those that the right image showed too
  std::vector<Portrayed> portrayed_;
  camera::StereoModel model_ = {};
};

}  // namespace pizarra::vision
