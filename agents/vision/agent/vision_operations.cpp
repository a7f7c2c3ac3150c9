#include <cmath>
#include <fmt/format.h>
#include <ranges>

#include "agents/vision/agent/vision_replies.hpp"
#include "agents/vision/agent/vision_state.hpp"
#include "agents/vision/marks/tags.hpp"

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

Task<Result<Datum>> VisionAgent::State::answer_failed(std::string text, Failure why) {
  const Datum symbol = Datum::symbol(why.symbol);
  std::vector<Datum> failed{list("vision-failed"_sym, feed.frame_number(), text, symbol, describe(why))};
  co_await facts.tell(std::move(failed));
  co_return list(text);
}

Task<Result<Datum>> VisionAgent::State::learn(std::string client, double x, double y, std::string name) {
  const Result<void> good_name = check_object_name(name);
  if (!good_name) co_return fail(good_name);
  const Result<void> free = co_await take_turn(Activity::none);
  if (!free) co_return fail(free);
  co_await begin(Activity::learning, std::move(client));
  Result<LearnedSample> sample = co_await learn_sample(name, x, y);
  Result<std::int64_t> kept = sample ? Result<std::int64_t>(0) : fail(sample);
  if (sample) {
    ObjectChange keep = KeepSample{name, std::move(*sample)};
    kept = co_await change_objects(std::move(keep));
  }
  if (kept) {
    to_accept = kept_as(name, *kept);
    co_await tell_objects();
  }
  co_await finish_activity();
  if (kept) co_return list(learn_reply(name, true));
  const std::string text = learn_reply(name, false);
  const Result<Datum> answer = co_await answer_failed(text, kept.error());
  co_return answer;
}

Task<Result<LearnedSample>> VisionAgent::State::learn_sample(std::string name, double x, double y) {
  learner.emplace(name, cv::Point2d(x, y), objects);
  while (!learner->done()) {
    const Result<StereoFrame> frame = co_await feed.next(longest_frame_wait);
    if (!frame) co_return fail(frame);
    const GreyPair grey = grey_pair(*frame);
    StereoSight sight(grey.left, grey.right, *feed.model());
    const Result<void> fed = learner->feed(sight);
    if (!fed) co_return fail(fed);
  }
  co_return learner->sample();
}

// In no database all ids are 0, and the newest is the agent's own.
std::optional<VisionAgent::State::ToAccept> VisionAgent::State::kept_as(const std::string& name,
                                                                        std::int64_t id) const {
  const LearnedObject* object = objects.find(name);
  if (object == nullptr) return std::nullopt;
  for (const LearnedSample& sample : object->samples | std::views::reverse) {
    if (sample.id == id) return ToAccept{object->name, sample.number, id};
  }
  return std::nullopt;
}

Task<Result<std::int64_t>> VisionAgent::State::change_objects(ObjectChange change) {
  const SampleNames before = names_of_samples();
  const RenameObject* const renaming = std::get_if<RenameObject>(&change);
  Renames own;
  if (renaming != nullptr) own.emplace(renaming->name, renaming->new_name);
  const Result<std::int64_t> changed = co_await memory.change(std::move(change));
  if (!changed) co_return changed;
  Renames renames = renamed_since(before);
  renames.merge(own);
  co_await follow_renames(std::move(renames));
  co_return changed;
}

Task<Result<Datum>> VisionAgent::State::find(std::string client, std::string name) {
  const Result<void> free = co_await take_turn(Activity::tracking);
  if (!free) co_return fail(free);
  co_await begin(Activity::finding, std::move(client));
  const Result<SeenMark> found = co_await find_mark(name);
  co_await finish_activity();
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
    // It may have been forgotten meanwhile.
    const LearnedObject* object = objects.find(name);
    if (object == nullptr) co_return fail(not_known(name));
    const GreyPair grey = grey_pair(*frame);
    StereoSight sight(grey.left, grey.right, *feed.model());
    const auto before = found_at.find(object->name);
    const auto seen_last = before == found_at.end() ? std::nullopt : std::optional(before->second);
    const std::optional<SeenPair> found = sight.find(objects, *object, {}, 0, {}, seen_last);
    if (!found) why = not_found(sight, *object);
    if (!found) continue;
    found_at.insert_or_assign(object->name, found->left.centre);
    std::vector<Datum> told{found_fact(frame->number, sight, *object, *found)};
    co_await facts.tell(std::move(told));
    co_return found->left;
  }
  co_return fail(why);
}

Failure VisionAgent::State::not_known(const std::string& name) const {
  const Failure* trouble = memory.trouble_with(name);
  if (trouble == nullptr) return {"not-learned", "nothing is learned under this name", to_datum(name), {}};
  return {
      "damaged",
      fmt::format("what was learned under this name is damaged, {}: {}", trouble->subject.text(), trouble->sentence),
      to_datum(name),
      {}};
}

Failure VisionAgent::State::not_found(StereoSight& sight, const LearnedObject& object) const {
  if (object.tag() != nullptr && find_tags(sight.left(), *object.tag()).size() > 1) {
    return {"ambiguous", "its tag is there more than once", to_datum(object.name), {}};
  }
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

// (found NAME FRAME CONFIDENCE SECOND MARGIN ((X Y) ...) PLACES)
Datum VisionAgent::State::found_fact(std::uint64_t frame, StereoSight& sight, const LearnedObject& object,
                                     const SeenPair& pair) const {
  constexpr std::size_t most_others = 8;
  const auto rounded = [](double value, double parts) { return std::round(value * parts) / parts; };
  const Likeness& likely = pair.likeness;
  std::vector<Datum> elsewhere;
  for (const cv::Point2d& place : others_like(sight.left_segmentation().marks(), objects, object, pair.left)) {
    if (elsewhere.size() < most_others) elsewhere.push_back(list(rounded(place.x, 100), rounded(place.y, 100)));
  }
  const SeenRange range = range_of(sight, object, pair).value_or(SeenRange());
  const std::optional<cv::Point2d> right = pair.right ? std::optional(pair.right->centre) : std::nullopt;
  return list("found"_sym, object.name, frame, rounded(confidence_at_first(sight, object, pair), 1000),
              likely.second == nullptr ? "" : likely.second->name, rounded(likely.margin(), 1000),
              Datum::list(std::move(elsewhere)), places_datum({pair.left.centre, right, range.mm, range.spread_mm}));
}

Task<Result<Datum>> VisionAgent::State::track(std::string client, std::string name) {
  const std::string holder = co_await holder_for(std::move(client));
  const Result<void> free = co_await take_turn(Activity::tracking);
  if (!free) co_return fail(free);
  const LearnedObject* object = objects.find(name);
  if (object == nullptr) co_return fail(not_known(name));
  const LearnedObject* end_effector = objects.find(end_effector_name);
  for (const LearnedObject* each : {end_effector, object}) {
    if (each == nullptr) continue;
    const Result<void> added = tracker.add(*each);
    if (!added) co_return fail(added);
    holders.track(holder, each->name);
  }
  activity = Activity::tracking;
  holders.connect(holder);
  feed.start();
  co_await tell_state();
  co_return Datum();
}

Task<Result<Datum>> VisionAgent::State::end_track(std::string client) {
  if (holders.tracker().empty()) co_return Datum();
  if (!holders.tracks(client)) {
    const std::string holder = holders.tracker();
    co_return fail("busy", fmt::format("{} tracks, and ends it itself", holder), Datum::symbol(holder));
  }
  holders.end_track(client);
  co_await follow_holders();
  co_return Datum();
}

Task<Result<Datum>> VisionAgent::State::connect(std::string client) {
  const std::string holder = co_await holder_for(std::move(client));
  holders.connect(holder);
  feed.start();
  co_await tell_state();
  co_return Datum();
}

Task<Result<Datum>> VisionAgent::State::disconnect(std::string client) {
  holders.disconnect(client);
  co_await follow_holders();
  co_return Datum();
}

Task<Result<Datum>> VisionAgent::State::keep_modes(std::string client) {
  const std::string holder = co_await holder_for(std::move(client));
  if (!holders.keep(holder)) co_return fail("nothing-held", "who asks is neither connected nor tracks", "keep"_sym);
  co_await tell_holders();
  co_return Datum();
}

Task<Result<Datum>> VisionAgent::State::get_objects() {
  co_await follow_memory();
  co_return list(get_reply(objects));
}

Result<void> VisionAgent::State::check_to_accept(const std::string& name) const {
  if (to_accept && same_name(to_accept->name, name)) return {};
  return fail("nothing-to-accept", "the sample that was learned last is not of this name, or has been judged already",
              to_datum(name));
}

Task<Result<Datum>> VisionAgent::State::accept(std::string name) {
  co_await follow_memory();
  const Result<void> waiting = check_to_accept(name);
  if (!waiting) co_return fail(waiting);
  to_accept.reset();
  co_await tell_objects();
  co_return Datum();
}

Task<Result<Datum>> VisionAgent::State::reject(std::string name) {
  co_await follow_memory();
  const Result<void> waiting = check_to_accept(name);
  if (!waiting) co_return fail(waiting);
  ObjectChange withdraw = WithdrawSample{to_accept->name, to_accept->number, to_accept->id};
  const Result<std::int64_t> done = co_await change_objects(std::move(withdraw));
  if (!done) co_return fail(done);
  co_return Datum();
}

Task<Result<Datum>> VisionAgent::State::forget(std::string name) {
  const Result<void> free = co_await take_turn(Activity::tracking);
  if (!free) co_return fail(free);
  ObjectChange forget = ForgetObject{name};
  const Result<std::int64_t> done = co_await change_objects(std::move(forget));
  if (!done) co_return fail(done);
  co_return Datum();
}

Task<Result<Datum>> VisionAgent::State::rename(std::string name, std::string new_name) {
  const Result<void> good_name = check_object_name(new_name);
  if (!good_name) co_return fail(good_name);
  const Result<void> free = co_await take_turn(Activity::tracking);
  if (!free) co_return fail(free);
  const LearnedObject* object = objects.find(name);
  if (object != nullptr) name = object->name;
  ObjectChange rename = RenameObject{name, new_name};
  const Result<std::int64_t> done = co_await change_objects(std::move(rename));
  if (!done) co_return fail(done);
  co_return Datum();
}

}  // namespace pizarra
