#include "agents/vision/sight/track_confidence.hpp"

#include <algorithm>

#include "agents/vision/marks/mark_outline.hpp"
#include "agents/vision/sight/covered_part.hpp"

namespace pizarra::vision {
namespace {

// Below this doubt about the ground around it, nothing covered the mark. Whether something covers it later, its size
// and its motion tell a pair.
constexpr double little_doubt = 0.5;

// Blur bends edges beside the bends of an outline, about as much in each look. An arc is bent by what covers a part.
double bent_in_each_look_px(const PlaneView& plane) {
  const PlaneOutline& outline = plane.sample->plane;
  const bool has_bends = std::ranges::any_of(outline.bends, &BendsAround::any);
  return has_bends ? off_if_bent_px(outline, plane.fit) : 0;
}

}  // namespace

double confidence_before_one(const StereoSight& sight, TrackedMark& track, const LearnedObject& object, SeenPair& now,
                             bool goes_on) {
  const bool is_there = goes_on || (track.left && track.left->box.contains(now.left.centre));
  if (!is_there) track.known_bend_px.reset();
  if (!now.plane) return confidence_in_look(sight, object, now);
  PlaneView& plane = *now.plane;
  plane.known_bend_px = track.known_bend_px;
  const double told = confidence_in_look(sight, object, now);
  if (!track.known_bend_px && told >= surely) track.known_bend_px = bent_in_each_look_px(plane);
  if (!is_triangle(outline_of(now.left.signature))) return told;
  const double range_mm = cv::norm(plane.pose->place_mm);
  const double off_px = track.nearest.off_if_covered_px(plane.sample->plane, plane.fit, range_mm, goes_on);
  return std::min(told, confidence_if_off(now.likeness.confidence(), off_px, most_off_px(sight)));
}

double confidence_before_pair(const StereoSight& sight, TrackedMark& track, const SeenPair& now, double may_be_off_px) {
  const double of_whole = now.likeness.confidence();
  const bool known = track.left && !track.missed && track.ground_doubt < little_doubt;
  if (!known) track.ground_doubt = ground_doubt(sight, now);
  track.nearest = {};
  const double by_look = confidence_if_off(of_whole, may_be_off_px, most_off_px(sight));
  const double told = confidence_if_off(by_look, track.ground_doubt, 1);
  return confidence_by_outline(told, of_whole, now, most_off_px(sight));
}

}  // namespace pizarra::vision
