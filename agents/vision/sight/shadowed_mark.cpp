#include "agents/vision/sight/shadowed_mark.hpp"

#include <cmath>

#include "agents/vision/sight/follow_mark.hpp"

namespace pizarra::vision {
namespace {

// How far from where it is expected it is looked for, in an image 320 px wide.
constexpr double reach_px = 12;
// How surely light makes the ground uneven, and nothing that hides a part.
constexpr double surely_light = 0.9;
// How far from its place, and what part of its size, a mark at rest may be off.
constexpr double at_rest_px = 1;
constexpr double at_rest_part = 0.05;

bool is_light(StereoSight& sight, const LearnedObject& object, const SeenMark& mark) {
  const std::optional<PlaneView> plane = view_plane(sight.left_segmentation().cut(), object, mark);
  return plane && plane->agrees && plane->ground.light > surely_light;
}

}  // namespace

std::optional<LitMark> LitMark::of(const SeenMark& mark) {
  if (mark.flattened) return std::nullopt;
  return LitMark{mark.centre, mark.width_px, mark.height_px};
}

bool LitMark::is(const SeenMark& now) const {
  const auto is_as_long = [](double was, double length) { return std::abs(length / was - 1) < at_rest_part; };
  return cv::norm(now.centre - centre) < at_rest_px && is_as_long(width_px, now.width_px) &&
         is_as_long(height_px, now.height_px);
}

std::optional<SeenPair> find_in_shadow(StereoSight& sight, const LearnedObjects& objects, const LearnedObject& object,
                                       const SeenMark& last, cv::Point2d expected, const std::optional<LitMark>& lit) {
  const int reach = cvRound(px_in(sight.left(), reach_px));
  const cv::Rect box = last.box + cv::Point(expected - last.centre) - cv::Point(reach, reach);
  StereoSight near = sight.within({box.tl(), box.size() + cv::Size(2 * reach, 2 * reach)});
  for (SeenPair& seen : near.find_in_plane(objects, object)) {
    if (cv::norm(seen.left.centre - expected) > reach) continue;
    if ((lit && lit->is(seen.left)) || is_light(near, object, seen.left)) return std::move(seen);
  }
  return std::nullopt;
}

}  // namespace pizarra::vision
