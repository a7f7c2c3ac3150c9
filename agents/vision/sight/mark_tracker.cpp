#include "agents/vision/sight/mark_tracker.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <opencv2/imgproc.hpp>
#include <utility>

#include "agents/vision/marks/other_outline.hpp"
#include "agents/vision/marks/tags.hpp"
#include "agents/vision/sight/covered_part.hpp"
#include "agents/vision/sight/face_plane.hpp"
#include "agents/vision/sight/follow_mark.hpp"
#include "agents/vision/sight/frame_time.hpp"
#include "agents/vision/sight/lost_mark.hpp"
#include "agents/vision/sight/seen_range.hpp"
#include "agents/vision/sight/track_confidence.hpp"

namespace pizarra::vision {
namespace {

// How far another mark moves from one image to the next, at most, that is none of what is lost just then.
constexpr double another_rests_px = 3;
// How much of the confidence is left after every tenth of a second in which a mark was not seen.
constexpr double trust_in_a_bridge = 0.7;
constexpr double trust_lasts_s = 0.1;
// The most confidence in a mark that may as well be another object's.
constexpr double trust_in_another = 0.5;
// With more of them a track begins among objects that look alike.
constexpr double least_twins = 0.1;

// Before one camera: the standard deviation of a mark, as a part of its distance. A larger mark is so near that the
// pose of a face which looks at the camera, in uneven light, puts the middle beside by more than the centroid is.
constexpr double largest_told_by_pose = 0.04;

// Whether the centre told is where the pose puts the mark's middle; else it is the centroid of its picture. A triangle
// that a pair learned aslant is stretched in its template, by a few percent any way: that moves its middle.
bool tells_middle(const StereoSight& sight, const PlanePose& lies, const SeenPair& pair) {
  if (pair.right) return lies.by_both && !is_triangle(outline_of(pair.left.signature));
  return std::hypot(pair.left.width_px, pair.left.height_px) < largest_told_by_pose * sight.model().focal_px;
}

SeenPair left_alone(SeenPair pair) {
  pair.right.reset();
  pair.right_by_outline = false;
  return pair;
}

}  // namespace

Result<void> MarkTracker::add(const LearnedObject& object, std::optional<cv::Point2d> seen_last) {
  for (const TrackedMark& track : tracks_) {
    if (same_name(track.name, object.name)) return {};
  }
  if (tracks_.size() >= most_tracked) {
    return fail("full", fmt::format("no more than {} objects can be tracked", most_tracked), to_datum(object.name));
  }
  const auto place = same_name(object.name, end_effector_name) ? tracks_.begin() : tracks_.end();
  tracks_.insert(place, TrackedMark{.name = object.name, .seen_before = seen_last});
  return {};
}

void MarkTracker::rename(const Renames& renames) {
  std::vector<std::string> taken;
  for (const TrackedMark& track : tracks_) {
    const std::string now = name_now(renames, track.name);
    if (now != track.name) taken.push_back(now);
  }
  std::erase_if(tracks_, [&](const TrackedMark& track) {
    const bool is_taken =
        std::ranges::any_of(taken, [&](const std::string& name) { return same_name(name, track.name); });
    return is_taken && name_now(renames, track.name) == track.name;
  });
  for (TrackedMark& track : tracks_) track.name = name_now(renames, track.name);
  // Each is looked at in the next frame.
  paced_.clear();
}

std::vector<TrackSighting> MarkTracker::update(StereoSight& sight, Time captured) {
  frame_s_ = seconds_between(std::exchange(captured_, captured), captured);
  // Places and sizes in images of another size say nothing.
  const cv::Size size_before = std::exchange(image_size_, sight.left().size());
  const bool anew = !size_before.empty() && size_before != image_size_;
  std::vector<TrackSighting> out;
  out.reserve(tracks_.size());
  const auto begin_anew = [](TrackedMark& track) { track = TrackedMark{.name = track.name}; };
  if (anew) std::ranges::for_each(tracks_, begin_anew);
  if (anew) paced_.clear();
  ConfinedSights sights(sight);
  for (TrackedMark& track : tracks_) out.push_back(look_in_turn(sights, track));
  within_.clear();
  last_left_ = sight.left();
  last_segmentation_.reset();
  return out;
}

TrackSighting MarkTracker::look_in_turn(ConfinedSights& sights, TrackedMark& track) {
  SearchLimit limit = limits_.of(track.name);
  const auto within = within_.find(track.name);
  if (!limit.area && within != within_.end()) limit.area = within->second;
  StereoSight& sight = sights.of(limit.area);
  if (!limit.per_second) {
    paced_.erase(track.name);
    return update(sight, track);
  }
  Paced& paced = paced_[track.name];
  if (!paced.pace.is_due(captured_, *limit.per_second)) return paced.told;
  paced.told = update(sight, track);
  paced.pace.looked(captured_, *limit.per_second);
  // The camera may use its pixels again before the next look.
  paced.left = sight.left().clone();
  return paced.told;
}

std::optional<SeenPair> MarkTracker::follow(StereoSight& sight, const TrackedMark& track,
                                            const LearnedObject& object) const {
  if (!track.left) return std::nullopt;
  const std::optional<double> disparity = track.expected_disparity_px(captured_);
  if (object.tag() != nullptr) {
    const cv::Point motion = track.expected(captured_) - track.left->centre;
    return sight.follow(*object.tag(), area_around_tag(track.left->box + motion), disparity);
  }
  std::optional<SeenMark> left = follow_mark(sight.left(), sight.noise(), *track.left, track.expected(captured_));
  if (!left) return std::nullopt;
  const std::optional<int> turn = track.likeness ? std::optional(track.likeness->turn) : std::nullopt;
  std::optional<Likeness> likely = recognise(*left, objects_, object, turn);
  if (!likely) likely = likeness_by_outline(sight, track, object, *left);
  if (!likely) return std::nullopt;
  SeenPair out{.left = std::move(*left), .right = std::nullopt, .likeness = *likely};
  find_in_right(sight, track, object, out);
  const bool by_regions = out.right && !out.right_by_outline;
  if (by_regions && !is_whole(sight.model(), object, out.left, *out.right)) return std::nullopt;
  return out;
}

// Where it is expected, or else anywhere; or by its outline alone.
void MarkTracker::find_in_right(StereoSight& sight, const TrackedMark& track, const LearnedObject& object,
                                SeenPair& pair) const {
  const std::optional<double> disparity = track.expected_disparity_px(captured_);
  const cv::Point2d expected = pair.left.centre - cv::Point2d(disparity.value_or(0), 0);
  if (disparity) pair.right = follow_mark(sight.right(), sight.noise(), *track.right, expected);
  if (pair.right && are_partners(pair.left, *pair.right)) return;
  pair.right.reset();
  const SeenMark* partner = find_partner(pair.left, sight.right_segmentation().marks(), disparity);
  if (partner != nullptr) pair.right = *partner;
  if (pair.right || !disparity) return;
  pair.right = track.plane.follow_in_right(sight, object, *track.right, expected);
  pair.right_by_outline = pair.right.has_value();
}

// Seen far aslant a mark may not be recognised. Its outline may still be.
std::optional<Likeness> MarkTracker::likeness_by_outline(const StereoSight& sight, const TrackedMark& track,
                                                         const LearnedObject& object, const SeenMark& mark) const {
  const auto is_it = [&](const LearnedObject& other) {
    return !same_name(other.name, object.name) && is_recognised(mark, objects_, other);
  };
  if (!track.plane.recognises(sight, object, mark) || std::ranges::any_of(objects_.all(), is_it)) return std::nullopt;
  std::optional<Likeness> out = track.likeness;
  if (out) out->second = objects_.find(track.second);
  return out;
}

void MarkTracker::note_others_before(TrackedMark& track, const LearnedObject& object, StereoSight* now) {
  const auto paced = paced_.find(track.name);
  const bool is_paced = paced != paced_.end() && !paced->second.left.empty();
  const cv::Mat& before = is_paced ? paced->second.left : last_left_;
  if (object.tag() != nullptr) {
    return track.others.note(*track.left, find_tags(before, *object.tag()), objects_, object);
  }
  std::optional<ImageSegmentation> of_paced;
  std::optional<ImageSegmentation>& segmentation = is_paced ? of_paced : last_segmentation_;
  if (!segmentation) segmentation.emplace(before, noise_of(before), track.left->focal_px);
  std::vector<SeenMark> marks = segmentation->marks();
  const cv::Point2d motion = track.expected(captured_) - track.left->centre;
  if (now != nullptr) drop_moved(marks, now->left_segmentation().marks(), motion, px_in(now->left(), another_rests_px));
  track.others.note(*track.left, marks, objects_, object);
}

// The sighting of a frame in which the mark was not found.
TrackSighting MarkTracker::miss(TrackedMark& track, Time now) const {
  track.whole.wait(now);
  TrackSighting out{.name = track.name, .captured = now, .centre = {}, .yaw_deg = {}, .contour = {}};
  if (!track.is_bridged(now, image_size_)) {
    track.lose();
    return out;
  }
  track.missed = true;
  out.bridged = true;
  out.centre = track.expected(now) + track.middle_off_px;
  out.range_mm = track.range_mm;
  out.confidence = track.confidence * std::pow(trust_in_a_bridge, seconds_between(track.seen_at, now) / trust_lasts_s);
  return out;
}

void MarkTracker::come_back(StereoSight& sight, TrackedMark& track, const LearnedObject& object, SeenPair& now) const {
  TrackedMark before = *track.before;
  before.velocity_px = {};
  before.disparity_change_px = 0;
  before.whole.wait(captured_);
  std::optional<SeenPair> there = follow(sight, before, object);
  if (!there || now.left.box.contains(there->left.centre)) return;
  // A cube that fell shows another of its faces where its mark was.
  if (may_be_one_cube(now.left, there->left, front_slimness(object))) return;
  if (!before.whole.look_at(sight.model(), object, *there, captured_, most_off_px(sight), false).whole) return;
  before.name = track.name;
  before.missed = true;
  before.others = track.others;
  before.others.add(now.left.centre);
  track = std::move(before);
  now = std::move(*there);
}

// Not for tags: none is followed where the same one is seen several times.
void MarkTracker::count_twins(StereoSight& sight, TrackedMark& track, const LearnedObject& object,
                              SeenPair& now) const {
  const bool may_be_another = track.began_among_alike.value_or(true) && object.tag() == nullptr;
  if (!may_be_another) return;
  now.likeness.twins = twins_of(sight.left_segmentation().marks(), objects_, object, now.left);
  if (!track.began_among_alike) track.began_among_alike = now.likeness.twins > least_twins;
}

void MarkTracker::note_loss(TrackedMark& track, const LearnedObject& object, StereoSight* now) {
  if (!track.left || track.missed) return;
  note_others_before(track, object, now);
  if (!track.before) track.before = std::make_shared<const TrackedMark>(track);
}

std::vector<TrackSighting> MarkTracker::miss_all(Time now) {
  std::vector<TrackSighting> out;
  if (last_left_.empty()) return out;
  for (TrackedMark& track : tracks_) {
    const LearnedObject* object = objects_.find(track.name);
    if (object != nullptr) note_loss(track, *object, nullptr);
    out.push_back(miss(track, now));
    const auto paced = paced_.find(track.name);
    if (paced != paced_.end()) paced->second.told = out.back();
  }
  return out;
}

// Motion and size say whether it is whole; so does its outline, where that goes on from the last frame.
MarkTracker::SeenWhole MarkTracker::look_at(const StereoSight& sight, const TrackedMark& track,
                                            const LearnedObject& object, SeenPair pair) const {
  SeenWhole out{std::move(pair), {}, false, track.plane};
  out.look = out.pair.right_by_outline
                 ? Wholeness::Look{.whole = false}
                 : track.whole.look_at(sight.model(), object, out.pair, captured_, most_off_px(sight), !track.left);
  if (std::optional<FollowedLook> lies = out.plane.look(sight, object, out.pair)) {
    out.goes_on = lies->goes_on;
    const PlaneView& view = lies->view;
    const bool is_known = out.goes_on && track.confidence >= surely;
    out.pair.likeness.other_form =
        view.pose->odds_of_no_plane() + (is_known ? 0 : odds_of_other_outline(view.sample->plane, view.fit));
    out.pair.plane = std::move(lies->view);
  }
  if (!out.pair.plane || !out.pair.plane->may_be_off_px || out.look.elsewhere) return out;
  double& may_be_off_px = *out.pair.plane->may_be_off_px;
  const PlanePose& pose = *out.pair.plane->pose;
  const cv::Point2d middle = middle_in_image(sight.model(), pose, most_off_px(sight));
  const bool is_beside = !out.pair.right && !tells_middle(sight, pose, out.pair);
  if (is_beside) may_be_off_px += cv::norm(middle - out.pair.left.centre);
  if (out.look.whole || !out.goes_on || may_be_off_px > most_off_px(sight)) return out;
  out.look.may_be_off_px = may_be_off_px;
  out.look.anew = true;
  out.look.whole = true;
  return out;
}

// Follows it, or looks for it elsewhere; nothing where it is not seen whole.
std::optional<MarkTracker::SeenWhole> MarkTracker::see(StereoSight& sight, TrackedMark& track,
                                                       const LearnedObject& object) {
  std::optional<SeenPair> now = follow(sight, track, object);
  if (now && track.doubted_for > Duration()) come_back(sight, track, object, *now);
  // It may be followed out of the area.
  if (now && !sight.holds(now->left)) now.reset();
  std::optional<SeenWhole> seen;
  if (now) seen = look_at(sight, track, object, std::move(*now));
  if (seen && seen->pair.right_by_outline && !seen->look.whole) {
    seen = look_at(sight, track, object, left_alone(std::move(seen->pair)));
  }
  if (!seen || !seen->look.whole) note_loss(track, object, &sight);
  if (!seen) {
    now = find_lost(sight, track, objects_, object, captured_);
    if (now) seen = look_at(sight, track, object, std::move(*now));
  }
  if (seen && !seen->look.whole) seen.reset();
  return seen;
}

// That it is the object, and whole.
MarkTracker::Confidence MarkTracker::confidence_in(StereoSight& sight, TrackedMark& track, const LearnedObject& object,
                                                   SeenWhole& seen) const {
  SeenPair& now = seen.pair;
  count_twins(sight, track, object, now);
  double told = now.likeness.confidence();
  if (!now.left.tag) {
    told = now.right ? confidence_before_pair(sight, track, now, seen.look.may_be_off_px)
                     : confidence_before_one(sight, track, object, now, seen.goes_on);
  }
  const double in_whole = confidence_in_whole(told, now.left.tag ? 1 : now.likeness.confidence_if_covered());
  // A triangle without a side has two. Its region alone shows what hides a part of another one as well.
  const bool may_be_cut = now.right_by_outline && is_triangle(outline_of(now.left.signature));
  if (may_be_cut) told = std::min(told, trust_in_another);
  if (track.is_doubted(now, captured_)) told = std::min(told, trust_in_another);
  return {told, in_whole};
}

// Where it is and how it lies. Seen is what has a range.
void MarkTracker::measure(StereoSight& sight, TrackedMark& track, const LearnedObject& object, const SeenWhole& seen,
                          double in_whole, TrackSighting& out) const {
  const SeenPair& now = seen.pair;
  const PlanePose* lies = now.plane ? &*now.plane->pose : nullptr;
  // In one of the images it is registered with something else, or in part.
  if (lies != nullptr && lies->by_both && lies->is_contradicted()) lies = nullptr;
  track.plane = seen.plane;
  const bool is_triangular = is_triangle(outline_of(now.left.signature));
  std::optional<SeenRange> range;
  if (now.right) {
    const FacePlane plane = face_plane(sight.model(), now.left, *now.right);
    range = range_by_pair(sight, now, in_whole, lies != nullptr && lies->by_both ? lies : nullptr);
    out.right_centre = now.right->centre;
    out.yaw_deg = yaw_deg(plane);
  } else if (sight.is_cut_off(object, now.left)) {
    // Of a large triangle four poses look alike: its longer axis says more, which is as long at either tilt.
    range = range_by_size(sight.model(), object, now.left, is_triangular ? nullptr : lies);
  }
  if (lies != nullptr) out.pose = pose_of(sight.model(), *lies, range);
  if (now.left.tag) out.pose = pose_of(sight.model(), object, now, range);
  if (!range) return;
  if (lies != nullptr && tells_middle(sight, *lies, now)) {
    out.centre = middle_in_image(sight.model(), *lies, most_off_px(sight));
    if (now.right) out.right_centre = out.centre - cv::Point2d(disparity_px(sight.model(), lies->place_mm[2]), 0);
  }
  track.middle_off_px = out.centre - now.left.centre;
  out.seen = true;
  out.range_mm = range->mm;
  out.range_spread_mm = range->spread_mm;
  track.range_mm = range->mm;
  if (now.right_by_outline) {
    track.whole.wait(captured_);
  } else {
    track.whole.follow(now, seen.look, captured_);
  }
}

TrackSighting MarkTracker::update(StereoSight& sight, TrackedMark& track) {
  const LearnedObject* object = objects_.find(track.name);
  if (object == nullptr) return miss(track, captured_);
  std::optional<SeenWhole> seen = see(sight, track, *object);
  if (!seen) return miss(track, captured_);
  SeenPair& now = seen->pair;
  TrackSighting out{
      .name = track.name, .captured = captured_, .centre = now.left.centre, .yaw_deg = {}, .contour = now.left.contour};
  track.likeness = now.likeness;
  // The second object may be forgotten before the next frame: its name is kept.
  track.likeness->second = nullptr;
  track.second = now.likeness.second != nullptr ? now.likeness.second->name : "";
  const Confidence confidence = confidence_in(sight, track, *object, *seen);
  out.confidence = confidence.told;
  if (now.likeness.second != nullptr) out.second = now.likeness.second->name;
  out.margin = now.likeness.margin();
  measure(sight, track, *object, *seen, confidence.in_whole, out);
  const bool begins = !track.left;
  track.take(std::move(now), captured_, frame_s_, most_step_px(sight));
  // A tag that is followed has no others.
  if (begins && object->tag() == nullptr)
    track.others.note(*track.left, sight.left_segmentation().marks(), objects_, *object);
  track.confidence = out.confidence;
  return out;
}

}  // namespace pizarra::vision
