#pragma once

// One pair of images as the eyes see it: both segmented, as much and when it is needed, and objects found in it.
//
//   StereoSight sight(frame, model);
//   std::optional<SeenPair> circle = sight.find(objects, *objects.find("circle"));

#include <array>
#include <map>
#include <optional>
#include <span>
#include <string>

#include "agents/vision/marks/edge_chains.hpp"
#include "agents/vision/marks/segmentation.hpp"
#include "agents/vision/marks/tag_detection.hpp"
#include "agents/vision/objects/mark_choice.hpp"
#include "agents/vision/sight/plane_view.hpp"
#include "agents/vision/sight/stereo.hpp"

namespace pizarra::vision {

struct SeenPair {
  SeenMark left;
  std::optional<SeenMark> right;  // absent where the right image does not show it
  Likeness likeness = {};
  std::optional<PlaneView> plane = {};  // of the left image, where it was looked for
  bool right_by_outline = false;        // no region of the right image is its alone
};

// The image in grey; it shares the pixels of one that is grey already.
cv::Mat grey_of(const Image& image);

class StereoSight {
 public:
  // Of the model's size. The frame's pixels are shared, not copied, where they are grey already; they and the model
  // outlive it.
  StereoSight(const camera::StereoFrame& frame, const camera::StereoModel& model);
  StereoSight(const camera::StereoFrame& frame, const camera::StereoModel&& model) = delete;
  // Both 8 bit, one channel, of the model's size; shared, not copied. The model outlives it.
  StereoSight(cv::Mat left, cv::Mat right, const camera::StereoModel& model);
  StereoSight(cv::Mat left, cv::Mat right, const camera::StereoModel&& model) = delete;

  // The same pair, of which only what lies wholly within this area of the left image is looked for, and in the right
  // one only in the rows beside it. Both share their pixels.
  StereoSight within(const cv::Rect& area) const;
  // Whether the mark, of the left image, lies wholly within what is looked at.
  bool holds(const SeenMark& mark) const { return !area_ || (mark.box & *area_) == mark.box; }

  const cv::Mat& left() const { return left_; }
  const cv::Mat& right() const { return right_; }
  const camera::StereoModel& model() const { return model_; }
  // noise_of() the left image; the right sensor is of the same kind.
  double noise() const { return noise_; }
  ImageSegmentation& left_segmentation();
  ImageSegmentation& right_segmentation();

  // The object anywhere in the left image, or within `reach_px` of `near` where that is given, but at none of `others`;
  // with its partner, and whole. A partner may be missing only where the right image's edge cuts it off. Of several
  // that are as like it the one nearest to `seen_last`.
  std::optional<SeenPair> find(const LearnedObjects& objects, const LearnedObject& object,
                               std::optional<cv::Point2d> near = {}, double reach_px = 0,
                               std::span<const cv::Point2d> others = {}, std::optional<cv::Point2d> seen_last = {});
  // The object anywhere, more thoroughly: its outline is registered with every closed region of any light whose outline
  // is about it. Where an image has a shadow's edge across the mark, and where it is far away or turned away far.
  // The likest first.
  std::vector<SeenPair> find_in_plane(const LearnedObjects& objects, const LearnedObject& object);
  // The object by what is seen of it: where something hides a part, or joins its outline with another thing's. Before
  // one camera; each with its plane, the one with the longest outline first.
  std::vector<SeenPair> find_parts(const LearnedObjects& objects, const LearnedObject& object);
  // A tag in both images: within `area` of the left one where that is given, but at none of `others`; nowhere in the
  // right one where that does not show it. Where several cubes bear it, none of them.
  std::optional<SeenPair> find(const Tag& tag, std::optional<cv::Rect> area = {},
                               std::span<const cv::Point2d> others = {});
  // The same, sooner, where it is expected, and in the right image first where the disparity puts it.
  std::optional<SeenPair> follow(const Tag& tag, const cv::Rect& area, std::optional<double> disparity_px = {});
  // This tag, as often as the left image shows it.
  std::vector<SeenMark> tags(const Tag& tag, std::optional<cv::Rect> area = {});
  // Whether the right image ends before it could show the whole of the object's mark, going by its learned size, and
  // shows no part of it farther away: then it is a larger thing.
  bool is_cut_off(const LearnedObject& object, const SeenMark& left);

 private:
  StereoSight(cv::Mat left, cv::Mat right, const camera::StereoModel& model, double noise,
              std::optional<cv::Rect> area);
  // Of the right image; nothing: all of it.
  std::optional<cv::Rect> right_area() const;
  // In the right image, the likest first.
  std::vector<const SeenMark*> partners_of(const SeenMark& left);
  // In one image, the likest first; `regions` are computed once.
  using Regions = std::array<std::optional<std::vector<LevelRegion>>, 2>;  // by tone
  std::vector<SeenPair> looks_in_plane(ImageSegmentation& segmentation, Regions& regions, const LearnedObjects& objects,
                                       const LearnedObject& object) const;
  // This tag anywhere in what is looked at of the left image.
  std::vector<SeenMark> tags_anywhere(const Tag& tag);
  // Of those that are seen in the left image the one that is meant, with its partner.
  std::optional<SeenPair> pair_of(const Tag& tag, std::vector<SeenMark> seen, std::optional<double> disparity_px) const;

  cv::Mat left_;
  cv::Mat right_;
  const camera::StereoModel& model_;
  double noise_;
  std::optional<cv::Rect> area_;  // of the left image; nothing: all of it
  std::optional<ImageSegmentation> left_segmentation_;
  std::optional<ImageSegmentation> right_segmentation_;
  Regions left_regions_;
  Regions right_regions_;
  std::optional<EdgeChains> left_edges_;
  std::map<std::string, TagDetection> left_tags_;  // in all that is looked at, by family: several tags are looked for
  std::optional<ImageSegmentation> right_rows_;    // beside the first mark whose partner was looked for
};

// Whether the pair can be the whole of the object's mark: as large in the world as one of its samples, and, but for
// what yaw does, as wide in one image as in the other. Something in front of a part of it makes it too small, or hides
// more of it from one camera than from the other.
bool is_whole(const camera::StereoModel& model, const LearnedObject& object, const SeenMark& left,
              const SeenMark& right);

}  // namespace pizarra::vision
