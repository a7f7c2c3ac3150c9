#include "agents/vision/sight/mark_finder.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <ranges>

#include "agents/vision/sight/surest_look.hpp"
#include "agents/vision/sight/wholeness.hpp"

namespace pizarra::vision {
namespace {

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

// Of a tilted face the middle is not where the centroid of what is seen is; to a pair these say how far away it is.
void set_middle(const StereoSight& sight, SeenPair& pair) {
  const PlaneView* plane = pair.plane ? &*pair.plane : nullptr;
  if (pair.right || plane == nullptr || plane->is_part || !plane->agrees) return;
  const bool by_pose = plane->pose && !plane->pose->is_contradicted();
  pair.left.centre = by_pose ? middle_in_image(sight.model(), *plane->pose, most_off_px(sight))
                             : plane->fit.in_image(plane->sample->plane.middle);
}

}  // namespace

Result<FoundMark> MarkFinder::find(StereoSight& sight, const LearnedObject& object, Time now) {
  std::optional<FoundMark> found = object.tag() == nullptr ? find_shape(sight, object) : find_tag(sight, object);
  if (!found) return fail(not_found(sight, object));
  found->confidence = confidence_in_look(sight, object, found->pair);
  if (const std::optional<std::string_view> why = why_none(object, found->pair, found->confidence)) {
    return fail("not-seen", std::string(*why), to_datum(object.name));
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

// Before one camera, where nothing says which of several is meant, the surest one.
std::optional<SeenPair> MarkFinder::surest(StereoSight& sight, const LearnedObject& object) const {
  const std::optional<cv::Point2d> before = place_of(object.name);
  std::optional<SeenPair> likest = sight.find(objects_, object, {}, 0, {}, before);
  if (likest) look_at_plane(sight, object, *likest);
  if (likest && likest->right) return likest;
  SurestLook look(sight, objects_, object, std::move(likest), {});
  // Where it was is where it is, unless hardly anything speaks for that.
  if (before && look.is_clear()) return std::move(look).best();
  look.look_for_whole();
  look.look_for_parts();
  return std::move(look).best();
}

std::optional<FoundMark> MarkFinder::find_shape(StereoSight& sight, const LearnedObject& object) const {
  std::optional<SeenPair> pair = surest(sight, object);
  if (!pair) return std::nullopt;
  set_middle(sight, *pair);
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
