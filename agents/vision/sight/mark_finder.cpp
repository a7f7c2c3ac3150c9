#include "agents/vision/sight/mark_finder.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <ranges>

#include "agents/vision/marks/other_outline.hpp"
#include "agents/vision/sight/followed_plane.hpp"
#include "agents/vision/sight/whole_outline.hpp"
#include "agents/vision/sight/wholeness.hpp"

namespace pizarra::vision {
namespace {

// With less hardly anything speaks for it.
constexpr double least_confidence = 0.03;
// Of photographed prints that were so faint the learned ones, in a lamp's reflection, had more; other things had less.
constexpr double least_of_faint = 0.8;
// With more no other place is looked at; and by so much another one must be surer.
constexpr double clearly_sure = 0.35;
constexpr double clearly_surer = 0.3;
// Of two that are about as sure, the one whose edges contradict its pose by so much less is e^4 times as likely.
constexpr double clearly_likelier = 4;
// A faint square is more often a window of a house, so that a mark of twice its contrast is likelier.
const double clearly_bolder = std::log(2);
// The share of prints of one ink that are as faint.
constexpr double share_of_faint = 0.1;
// The ground beside a cover raises a greater doubt. In photographs with covered marks 64 of 66 wholes that were told
// where none was had one. Of 101 whole marks that were tilted and not sure, one in ten had.
constexpr double least_of_cover = 0.2;

std::optional<Failure> of_another_size(const std::vector<SeenMark>& marks, const LearnedObject& object) {
  for (const SeenMark& mark : marks) {
    const std::optional<double> scale = scale_of_another_size(mark, object);
    if (!scale) continue;
    return Failure{*scale > 1 ? "too-large" : "too-small",
                   fmt::format("a mark is like it, but {:.1f} times as high as it was learned, and it is looked for "
                               "from {} to {} times: learn it at this size too, under the same name",
                               *scale, least_scale, most_scale),
                   to_datum(object.name),
                   {}};
  }
  return std::nullopt;
}

// By how much another homography explains its edges better than any pose of it.
double contradiction(const SeenPair& pair) {
  const std::optional<PlanePose>* pose = pair.plane ? &pair.plane->pose : nullptr;
  return pose != nullptr && *pose ? std::max(0.0, (*pose)->misfit - (*pose)->free_misfit) : 0;
}

double contrast(const SeenPair& pair) { return print_contrast(pair.left); }

// A whole with uneven ground may be another thing that is covered; a faint one may be no print. The farther such a
// whole is turned away, the likelier is a part elsewhere.
bool gives_way(const StereoSight& sight, const SeenPair& whole, double of_whole, const SeenPair& part, double of_part) {
  const PlaneView* plane = whole.plane ? &*whole.plane : nullptr;
  if (plane == nullptr || plane->is_part || whole.left.box.contains(part.left.centre)) return false;
  const bool is_bolder = contrast(part) > contrast(whole) + clearly_bolder;
  const double by_outline = plane->agrees ? plane->ground.doubt : 1;
  if (!is_bolder && std::min(ground_doubt(sight, whole), by_outline) < least_of_cover) return false;
  const double turn = plane->pose ? usual_turn(*plane->pose) : 1;
  return of_part > of_whole * turn * (is_bolder ? share_of_faint : 1);
}

}  // namespace

Result<FoundMark> MarkFinder::find(StereoSight& sight, const LearnedObject& object, Time now) {
  std::optional<FoundMark> found = object.tag() == nullptr ? find_shape(sight, object) : find_tag(sight, object);
  if (!found) return fail(not_found(sight, object));
  found->confidence = confidence_in_look(sight, object, found->pair);
  if (found->confidence < least_confidence) {
    return fail("not-seen",
                "a mark is like it, but a part of it is hidden, or it is none: the ground around it, or its size, is "
                "another than a whole one's",
                to_datum(object.name));
  }
  const bool is_shape = !found->pair.left.tag;
  if (is_shape && found->confidence < least_of_faint && is_faint(found->pair.left, object)) {
    return fail("not-seen", "a mark is like it, but its print is much fainter than it was learned",
                to_datum(object.name));
  }
  found->range = range_of(sight, object, found->pair, found->confidence);
  found->pose = pose_of(sight.model(), object, found->pair, found->range);
  found_at_.insert_or_assign(object.name, FoundAt{found->pair.left.centre, now});
  return std::move(*found);
}

std::optional<cv::Point2d> MarkFinder::place_of(const std::string& name) const {
  const auto found = found_at_.find(name);
  return found == found_at_.end() ? std::nullopt : std::optional(found->second.place);
}

std::vector<FoundPlace> MarkFinder::found_since(Time then) const {
  std::vector<FoundPlace> out;
  for (const auto& [name, found] : found_at_) {
    if (found.when >= then) out.push_back({name, found.place});
  }
  return out;
}

void MarkFinder::rename(const Renames& renames) {
  std::map<std::string, FoundAt> now;
  for (const auto& [was, found] : found_at_) {
    const LearnedObject* object = objects_.find(name_now(renames, was));
    if (object != nullptr) now.insert_or_assign(object->name, found);
  }
  found_at_ = std::move(now);
}

// Before one camera, where nothing says which of several is meant, the surest one: a window of a house is a square as
// well, but for its perspective.
std::optional<SeenPair> MarkFinder::surest(StereoSight& sight, const LearnedObject& object) const {
  std::optional<SeenPair> best = sight.find(objects_, object, {}, 0, {}, place_of(object.name));
  if (best) look_at_plane(sight, object, *best);
  if (best && (best->right || place_of(object.name))) return best;
  double most = best ? confidence_in_look(sight, object, *best) : 0;
  const auto take_surer = [&](SeenPair&& other) {
    if (!other.plane) look_at_plane(sight, object, other);
    const double confidence = confidence_in_look(sight, object, other);
    const bool is_likelier =
        best && confidence > most - clearly_surer && contradiction(other) + clearly_likelier < contradiction(*best);
    const bool is_bolder =
        best && confidence > most - clearly_surer && contrast(other) > contrast(*best) + clearly_bolder;
    const bool is_surer = best ? confidence >= most + clearly_surer : confidence >= least_confidence;
    if (!is_likelier && !is_bolder && !is_surer) return;
    most = confidence;
    best = std::move(other);
  };
  const bool is_contradicted = best && contradiction(*best) > clearly_likelier;
  if (best && (most < clearly_sure || is_contradicted || is_faint(best->left, object))) {
    for (const SeenMark& mark : sight.left_segmentation().marks()) {
      const std::optional<Likeness> likely = recognise(mark, objects_, object);
      if (likely && !best->left.box.contains(mark.centre)) {
        take_surer({.left = mark, .right = std::nullopt, .likeness = *likely});
      }
    }
  }
  if (most < clearly_sure || is_contradicted) {
    for (SeenPair& thorough : sight.find_in_plane(objects_, object)) take_surer(std::move(thorough));
  }
  if (most < surely || is_faint(best->left, object)) {
    for (SeenPair& part : sight.find_parts(objects_, object)) {
      if (best && gives_way(sight, *best, most, part, confidence_in_look(sight, object, part))) best.reset();
      take_surer(std::move(part));
    }
  }
  return best;
}

// Of a tilted face the middle is not where the centroid of what is seen is; to a pair these say how far away it is.
void MarkFinder::look_at_plane(StereoSight& sight, const LearnedObject& object, SeenPair& pair) {
  pair.plane = view_plane(sight.left_segmentation().cut(), object, pair.left);
  if (!pair.plane) return;
  const LearnedSample& sample = *pair.plane->sample;
  pair.likeness.other_form = odds_of_other_outline(sample.plane, pair.plane->fit);
  if (!pair.plane->agrees) return;
  std::optional<PlaneFit> right;
  if (pair.right) right = fit_in_right(sight, sample, pair, pair.plane->fit, to_follow);
  std::optional<PlanePose>& pose = pair.plane->pose;
  pose = pose_in_plane(sight.model(), sample, pair.plane->fit, right ? &*right : nullptr);
  if (pose) pair.likeness.other_form += pose->odds_of_no_plane();
  const double most_px = most_off_px(sight);
  if (pose) {
    const RegisteredOutline seen{sample, pair.plane->fit, right ? &*right : nullptr, *pose, pair.right.has_value()};
    pair.plane->may_be_off_px = off_by_outline_px(seen, most_px);
  }
  // In one of both images it is registered with something else, or in part.
  if (pose && pose->by_both && pose->is_contradicted()) pose.reset();
  if (pair.right) return;
  pair.left.centre = pose && !pose->is_contradicted() ? middle_in_image(sight.model(), *pose, most_px)
                                                      : pair.plane->fit.in_image(sample.plane.middle);
}

std::optional<FoundMark> MarkFinder::find_shape(StereoSight& sight, const LearnedObject& object) const {
  std::optional<SeenPair> pair = surest(sight, object);
  if (!pair) return std::nullopt;
  const std::vector<SeenMark>& marks = sight.left_segmentation().marks();
  pair->likeness.twins = twins_of(marks, objects_, object, pair->left);
  return FoundMark{object.name, *pair, others_like(marks, objects_, object, pair->left)};
}

// Of several tags of one number one is told, as of shapes that are alike: the one nearest to where it was found last,
// or the largest.
std::optional<FoundMark> MarkFinder::find_tag(StereoSight& sight, const LearnedObject& object) const {
  std::optional<SeenPair> only = sight.find(objects_, object);
  if (only) return FoundMark{object.name, *only, {}};
  std::vector<SeenMark> tags = sight.tags(*object.tag());
  if (tags.empty()) return std::nullopt;
  const std::optional<cv::Point2d> before = place_of(object.name);
  const auto rank = [&](const SeenMark& tag) { return before ? cv::norm(tag.centre - *before) : -tag.area_px; };
  std::ranges::sort(tags, {}, rank);
  std::vector<cv::Point2d> elsewhere;
  for (const SeenMark& tag : tags | std::views::drop(1)) elsewhere.push_back(tag.centre);
  std::optional<SeenPair> pair = sight.find(objects_, object, {}, 0, elsewhere);
  if (!pair) return std::nullopt;
  pair->likeness.twins = static_cast<double>(elsewhere.size());
  return FoundMark{object.name, *pair, std::move(elsewhere)};
}

Failure MarkFinder::not_found(StereoSight& sight, const LearnedObject& object) const {
  std::string_view why = "no mark in the image is like it";
  bool is_like = false;
  ImageSegmentation& segmentation = sight.left_segmentation();
  for (const SeenMark& mark : segmentation.marks()) {
    const Likeness likely = likeness(mark, objects_, object);
    if (likely.error > recognition_threshold) continue;
    is_like = true;
    if (likely.doubt > 1) why = "a mark is like it, but has another outline";
    if (likely.doubt > 1 || !likely.is_ambiguous()) continue;
    return {"ambiguous",
            fmt::format("a mark looks like it, and as much like {}", likely.second->name),
            to_datum(object.name),
            {}};
  }
  std::optional<Failure> sized = is_like ? std::nullopt : of_another_size(segmentation.marks(), object);
  if (sized) return std::move(*sized);
  const bool all_seen = object.tag() != nullptr || segmentation.left_out() == 0;
  if (all_seen) return {"not-seen", std::string(why), to_datum(object.name), {}};
  return {"crowded",
          fmt::format("{}; only the {} largest were looked at, and {} smaller regions were not", why,
                      segmentation.marks().size(), segmentation.left_out()),
          to_datum(object.name),
          {}};
}

}  // namespace pizarra::vision
