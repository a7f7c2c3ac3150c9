#pragma once

// Marks whose true range is known, as a pair of cameras of any resolution sees them: drawn by the exact share of each
// pixel that they cover. How far what is told is off, in spreads told, is counted.
//
//   RangeViews views({.width = 1280, .height = 960, .focal_px = 1700});
//   RangeView view = views.random_view({.least_mm = 300, .most_mm = 1500}, random);
//   std::optional<RangeTold> told = views.look(view, random);
//   told->off_mm / told->spread_mm;

#include <opencv2/core.hpp>
#include <optional>
#include <string>

#include "agents/vision/sight/mark_tracker.hpp"
#include "blackboard/time/random.hpp"
#include "tests/bench/vision/outline.hpp"

namespace pizarra::vision {

// What a view is drawn from.
struct RangeConditions {
  double least_mm = 500, most_mm = 1000;
  double least_noise = 1, most_noise = 4;
  double least_blur_px = 0.5, most_blur_px = 0.8;
  double most_light_slope = 0.1;  // the share of light lost over the image's width, from any side
  double most_tilt_deg = 0;       // yaw, and pitch
  double most_roll_deg = 30;
};

struct RangeView {
  std::string mark;   // circle, square, cross, triangle or tag
  cv::Point3d place;  // of its centroid, mm from the middle of the base line; x right, y down
  double yaw_deg = 0, pitch_deg = 0, roll_deg = 0;
  double noise = 0;
  double blur_px = 0;
  cv::Point2d light_slope = {};
  bench::Shape cover = {};  // px of the left image, over the mark
  double cover_level = 90;
  double cover_disparity_px = 0;
};

struct RangeTold {
  double off_mm = 0;
  double spread_mm = 0;
  double confidence = 0;
};

class RangeViews {
 public:
  // With shapes and a tag learned.
  explicit RangeViews(const camera::StereoModel& camera);
  RangeViews(const camera::StereoModel& camera, LearnedObjects learned);

  RangeView random_view(const RangeConditions& conditions, Random& random) const;
  cv::Point2d seen_at(const cv::Point3d& point, bool right) const;
  cv::Mat1b draw(const RangeView& view, bool right, Random& random) const;
  // By the camera that the eyes believe to have. Nothing where they do not see it in both images.
  std::optional<RangeTold> look(const RangeView& view, const camera::StereoModel& believed, Random& random) const;
  std::optional<RangeTold> look(const RangeView& view, Random& random) const { return look(view, camera, random); }

  const camera::StereoModel camera;

 private:
  bench::Shape shape_of(const RangeView& view, bool right) const;

  const LearnedObjects learned_;
};

}  // namespace pizarra::vision
