#pragma once

// What a tracker keeps of one object: how its mark was seen last, where it should be by now, and, while it is lost, how
// it was before. It is bridged for half a second; then where it was says nothing more.
//
//   TrackedMark track{.name = "circle"};
//   track.take(std::move(pair), captured, most_step_px);     // it was seen
//   track.expected(later);
//   if (!track.is_bridged(later, image)) track.lose();       // it was not

#include <memory>

#include "agents/vision/sight/followed_plane.hpp"
#include "agents/vision/sight/known_twins.hpp"
#include "agents/vision/sight/nearest_look.hpp"
#include "agents/vision/sight/search_limits.hpp"
#include "agents/vision/sight/shadowed_mark.hpp"
#include "agents/vision/sight/wholeness.hpp"

namespace pizarra::vision {

inline constexpr Duration longest_bridge = 500ms;
inline constexpr Duration longest_doubt = 5s;  // whether what is found elsewhere is it

struct TrackedMark {
  std::string name;
  std::optional<cv::Point2d> seen_before = {};  // tracking began
  // Known once it has been seen; then it may be another as long as one of these is in view.
  std::optional<bool> began_among_alike = {};
  // As seen last, if that was no longer ago than longest_bridge.
  std::optional<SeenMark> left = {};
  std::optional<SeenMark> right = {};
  std::optional<LitMark> lit = {};
  std::optional<Likeness> likeness = {};  // without the second object
  std::string second = {};                // that one's name, where there is one
  Time seen_at = {};
  bool missed = false;  // in the frame before this one
  Wholeness whole = {};
  FollowedPlane plane = {};
  // Before one camera, where it has been told surely and its outline was seen there since (plane_view.hpp).
  std::optional<double> known_bend_px = {};
  NearestLook nearest = {};      // of a triangle before one camera
  double ground_doubt = 0;       // before a pair: as it was found, or since
  cv::Point2d velocity_px = {};  // a second, in the left image
  double disparity_change_px = 0;
  cv::Point2d middle_off_px = {};  // of what was told as its centre, from the centroid of its picture
  double range_mm = 0;
  double confidence = 0;
  KnownTwins others = {};
  LookPace looks_in_plane = {};  // of those while it is lost
  // As it was when it was lost; and for how long yet it must be followed elsewhere, where it was found since.
  std::shared_ptr<const TrackedMark> before = {};
  Duration doubted_for = {};

  // Where it should be by then, in the left image, and how far left of that in the right one where that showed it.
  cv::Point2d expected(Time then) const;
  std::optional<double> expected_disparity_px(Time then) const;
  bool is_bridged(Time now, cv::Size image) const;
  // What was seen becomes what is followed. A step of more than `most_step_px` since the frame before is no motion to
  // go by.
  void take(SeenPair&& now, Time captured, double frame_s, double most_step_px);
  // Where it was says nothing more.
  void lose();
  // Whether the mark seen may be another object's, by where it is.
  bool is_doubted(const SeenPair& now, Time captured);
};

}  // namespace pizarra::vision
