// FIND, and why nothing is found.

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <ranges>

#include "agents/vision/agent/vision_replies.hpp"
#include "agents/vision/agent/vision_state.hpp"
#include "agents/vision/marks/tags.hpp"
#include "agents/vision/sight/wholeness.hpp"

namespace pizarra {
namespace {

constexpr Duration longest_frame_wait = 3s;
constexpr int frames_to_find = 3;

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

}  // namespace

Task<Result<Datum>> VisionAgent::State::find(Asked asked) {
  const auto& [client, operation, name] = asked;
  co_await let_tracking_look();
  co_await begin_finding(client);
  // Another agent may just have forgotten or renamed it.
  co_await follow_memory();
  const Result<SeenMark> found = co_await find_mark(name);
  co_await end_finding(client);
  if (found) co_return list(find_reply(name, found->centre));
  const std::string text = find_reply(name, std::nullopt);
  const Result<Datum> answer = co_await answer_failed(text, found.error());
  co_return answer;
}

Task<Result<SeenMark>> VisionAgent::State::find_mark(std::string name) {
  if (objects.find(name) == nullptr) co_return fail(not_known(name));
  Failure why;
  for (int i = 0; i < frames_to_find; ++i) {
    const Result<StereoFrame> frame = co_await feed.next(longest_frame_wait);
    if (!frame) co_return fail(frame);
    tracking_is_next = true;
    // It may have been forgotten meanwhile.
    const LearnedObject* object = objects.find(name);
    if (object == nullptr) co_return fail(not_known(name));
    const GreyPair grey = grey_pair(*frame);
    StereoSight sight(grey.left, grey.right, *feed.model());
    const std::optional<Found> found = find_in(sight, *object);
    if (found) found_at.insert_or_assign(object->name, FoundAt{found->pair.left.centre, context.executor.now()});
    begin_showing(*frame, {});
    if (!found) why = not_found(sight, *object);
    if (!found) continue;
    std::vector<Datum> told{found_fact(frame->number, sight, *object, *found)};
    co_await facts.tell(std::move(told));
    co_return found->pair.left;
  }
  co_return fail(why);
}

std::optional<cv::Point2d> VisionAgent::State::place_found_last(const std::string& name) const {
  const auto found = found_at.find(name);
  return found == found_at.end() ? std::nullopt : std::optional(found->second.place);
}

Failure VisionAgent::State::not_known(const std::string& name) const {
  const Failure* trouble = memory.trouble_with(name);
  if (trouble == nullptr) return {"not-learned", "nothing is learned under this name", to_datum(name), {}};
  if (trouble->symbol == "full") {
    return {"full",
            fmt::format("it is kept, but {} objects are known already: forget another, and this one is known",
                        most_objects),
            to_datum(name),
            {}};
  }
  return {
      "damaged",
      fmt::format("what was learned under this name is damaged, {}: {}", trouble->subject.text(), trouble->sentence),
      to_datum(name),
      {}};
}

Failure VisionAgent::State::not_found(StereoSight& sight, const LearnedObject& object) const {
  std::string_view why = "no mark in the image is like it";
  bool is_like = false;
  ImageSegmentation& segmentation = sight.left_segmentation();
  for (const SeenMark& mark : segmentation.marks()) {
    const Likeness likely = likeness(mark, objects, object);
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

std::optional<VisionAgent::State::Found> VisionAgent::State::find_in(StereoSight& sight,
                                                                     const LearnedObject& object) const {
  return object.tag() == nullptr ? find_shape(sight, object) : find_tag(sight, object);
}

std::optional<VisionAgent::State::Found> VisionAgent::State::find_shape(StereoSight& sight,
                                                                        const LearnedObject& object) const {
  std::optional<SeenPair> pair = sight.find(objects, object, {}, 0, {}, place_found_last(object.name));
  if (!pair) return std::nullopt;
  const std::vector<SeenMark>& marks = sight.left_segmentation().marks();
  pair->likeness.twins = twins_of(marks, objects, object, pair->left);
  return Found{*pair, others_like(marks, objects, object, pair->left)};
}

// Of several tags of one number one is told, as of shapes that are alike: the one nearest to where it was found last,
// or the largest.
std::optional<VisionAgent::State::Found> VisionAgent::State::find_tag(StereoSight& sight,
                                                                      const LearnedObject& object) const {
  std::optional<SeenPair> only = sight.find(objects, object);
  if (only) return Found{*only, {}};
  std::vector<SeenMark> tags = find_tags(sight.left(), *object.tag());
  if (tags.empty()) return std::nullopt;
  const std::optional<cv::Point2d> before = place_found_last(object.name);
  const auto rank = [&](const SeenMark& tag) { return before ? cv::norm(tag.centre - *before) : -tag.area_px; };
  std::ranges::sort(tags, {}, rank);
  std::vector<cv::Point2d> elsewhere;
  for (const SeenMark& tag : tags | std::views::drop(1)) elsewhere.push_back(tag.centre);
  std::optional<SeenPair> pair = sight.find(objects, object, {}, 0, elsewhere);
  if (!pair) return std::nullopt;
  pair->likeness.twins = static_cast<double>(elsewhere.size());
  return Found{*pair, std::move(elsewhere)};
}

Datum VisionAgent::State::found_fact(std::uint64_t frame, const StereoSight& sight, const LearnedObject& object,
                                     const Found& found) {
  constexpr std::size_t most_others = 8;
  const auto rounded = [](double value, double parts) { return std::round(value * parts) / parts; };
  const SeenPair& pair = found.pair;
  const Likeness& likely = pair.likeness;
  std::vector<Datum> elsewhere;
  for (const cv::Point2d& place : found.elsewhere | std::views::take(most_others)) {
    elsewhere.push_back(list(rounded(place.x, 100), rounded(place.y, 100)));
  }
  const SeenRange range = range_of(sight, object, pair).value_or(SeenRange());
  const std::optional<cv::Point2d> right = pair.right ? std::optional(pair.right->centre) : std::nullopt;
  return list("found"_sym, object.name, frame, rounded(confidence_at_first(sight, object, pair), 1000),
              likely.second == nullptr ? "" : likely.second->name, rounded(likely.margin(), 1000),
              Datum::list(std::move(elsewhere)), places_datum({pair.left.centre, right, range.mm, range.spread_mm}));
}

}  // namespace pizarra
