#include "agents/vision/sight/lost_mark.hpp"

#include <algorithm>
#include <utility>

#include "agents/vision/sight/follow_mark.hpp"
#include "agents/vision/sight/surest_look.hpp"

namespace pizarra::vision {
namespace {

// How far a lost mark is looked for before the whole image is.
constexpr double local_reach_px = 48;
constexpr double looks_in_plane_per_second = 5;

bool may_look_in_plane(TrackedMark& track, Time captured) {
  if (!track.left && !track.looks_in_plane.is_due(captured, looks_in_plane_per_second)) return false;
  track.looks_in_plane.looked(captured, looks_in_plane_per_second);
  return true;
}

// Before one camera, as FIND finds it, beginning with the likest region; but no part of it, whose outline is not
// followed.
std::optional<SeenPair> find_surest(StereoSight& sight, TrackedMark& track, const LearnedObjects& objects,
                                    const LearnedObject& object, Time captured, std::optional<SeenPair> likest) {
  if (likest) look_at_plane(sight, object, *likest);
  SurestLook look(sight, objects, object, std::move(likest), track.others.places());
  if (!look.is_clear() && !may_look_in_plane(track, captured)) return std::nullopt;
  look.look_for_whole();
  const double confidence = look.confidence();
  std::optional<SeenPair> best = std::move(look).best();
  if (best && why_none(object, *best, confidence)) return std::nullopt;
  return best;
}

// In both images of a pair its outline tells it from what is hidden in part.
std::optional<SeenPair> find_in_plane(StereoSight& sight, TrackedMark& track, const LearnedObjects& objects,
                                      const LearnedObject& object, Time captured) {
  if (!may_look_in_plane(track, captured)) return std::nullopt;
  for (SeenPair& seen : sight.find_in_plane(objects, object)) {
    const auto is_there = [&](const cv::Point2d& other) { return seen.left.box.contains(other); };
    const bool may_be = sight.holds(seen.left) && !is_faint(seen.left, object);
    if (!may_be || std::ranges::any_of(track.others.places(), is_there)) continue;
    const std::optional<FollowedLook> lies = FollowedPlane().look(sight, object, seen);
    if (lies && lies->view.may_be_off_px && *lies->view.may_be_off_px < most_off_px(sight)) return std::move(seen);
  }
  return std::nullopt;
}

}  // namespace

double most_step_px(const StereoSight& sight) { return px_in(sight.left(), local_reach_px); }

std::optional<SeenPair> find_lost(StereoSight& sight, TrackedMark& track, const LearnedObjects& objects,
                                  const LearnedObject& object, Time captured) {
  const bool tagged = object.tag() != nullptr;
  if (!track.others.empty() && tagged) track.others.follow(sight.tags(*object.tag()), objects, object);
  if (!track.others.empty() && !tagged) track.others.follow(sight.left_segmentation().marks(), objects, object);
  std::optional<SeenPair> now;
  if (track.left) {
    const cv::Point2d expected = track.expected(captured);
    now = sight.find(objects, object, expected, most_step_px(sight), track.others.places());
    if (!now && !tagged) now = find_in_shadow(sight, objects, object, *track.left, expected, track.lit);
  }
  if (now) return now;
  const auto before = track.began_among_alike ? std::nullopt : track.seen_before;
  now = sight.find(objects, object, {}, 0, track.others.places(), before);
  if (tagged) return now;
  if (sight.model().is_single()) return find_surest(sight, track, objects, object, captured, std::move(now));
  return now ? std::move(now) : find_in_plane(sight, track, objects, object, captured);
}

}  // namespace pizarra::vision
