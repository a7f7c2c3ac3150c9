#pragma once

// Marks on faces that are turned away, learned and found by a pair of cameras, by its left one where the right one does
// not show them, or by one camera alone.
//
//   TiltedLooks looks(model);
//   looks.learn({.mark = "tag", .place = {0, 0, 500}}, random);
//   Result<FoundMark> found = looks.find({.mark = "tag", .place = {0, 0, 700}, .yaw_deg = 50}, Side::both, random);

#include <vector>

#include "agents/vision/sight/mark_finder.hpp"
#include "tests/agents/vision/range_views.hpp"

namespace pizarra::vision {

class TiltedLooks {
 public:
  enum class Side : std::uint8_t { both, left_alone };

  explicit TiltedLooks(const camera::StereoModel& camera);

  void learn(const RangeView& view, Random& random);
  Result<FoundMark> find(const RangeView& view, Side side, Random& random) const;

  StereoSight sight_of(const RangeView& view, Side side, Random& random) const;
  // As the last of so many frames tells it.
  TrackSighting track(const RangeView& view, int frames, Random& random) const;
  // One after the other, 30 a second.
  std::vector<TrackSighting> follow(const std::vector<RangeView>& views, Random& random) const;
  // Where the mark's middle is, in the left image or the right one.
  cv::Point2d middle_of(const RangeView& view, bool right = false) const { return views_.seen_at(view.place, right); }

  const camera::StereoModel camera;
  LearnedObjects objects;

 private:
  const RangeViews views_;
};

}  // namespace pizarra::vision
