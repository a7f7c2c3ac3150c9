// What a client asks of the eyes.

#include <algorithm>
#include <fmt/format.h>

#include "agents/vision/agent/reply_text.hpp"
#include "agents/vision/agent/vision_state.hpp"

namespace pizarra::vision {
namespace {

constexpr Duration longest_frame_wait = 3s;
constexpr int frames_to_find = 3;

}  // namespace

Task<Result<Datum>> VisionAgent::State::answer_failed(std::string text, Failure why) {
  const Datum symbol = Datum::symbol(why.symbol);
  std::vector<Datum> failed{list("vision-failed"_sym, feed.frame_number(), text, symbol, describe(why))};
  co_await facts.tell(std::move(failed));
  co_return list(text);
}

Task<Result<Datum>> VisionAgent::State::learn(Asked asked) {
  const auto& [client, operation, name, came] = asked;
  co_await begin_learning(client);
  const cv::Point2d click(operation[1].number(), operation[2].number());
  std::optional<std::uint64_t> clicked;
  if (operation.size() > 4) clicked = static_cast<std::uint64_t>(std::max<std::int64_t>(0, operation[3].integer()));
  Result<LearnedSample> sample = co_await learn_sample(name, click, clicked, came);
  Result<std::int64_t> kept = sample ? Result<std::int64_t>(0) : fail(sample);
  if (sample) {
    ObjectChange keep = KeepSample{name, std::move(*sample)};
    kept = co_await change_objects(std::move(keep));
  }
  const std::optional<int> number = kept ? number_of(name, *kept) : std::nullopt;
  if (number) {
    to_accept.add({client, name, *number, *kept, context.executor.now() + SamplesToAccept::lease});
    co_await tell_objects();
  }
  co_await end_learning();
  if (kept) co_return list(learn_reply(name, true));
  const std::string text = learn_reply(name, false);
  const Result<Datum> answer = co_await answer_failed(text, kept.error());
  co_return answer;
}

Task<Result<LearnedSample>> VisionAgent::State::learn_sample(std::string name, cv::Point2d click,
                                                             std::optional<std::uint64_t> clicked, Time asked) {
  learner.emplace(name, click, objects);
  Time after = asked;
  if (clicked) {
    const Result<camera::StereoFrame> shown = feed.kept(*clicked);
    if (!shown) co_return fail(shown);
    after = shown->captured - Duration(1);
  }
  while (!learner->done()) {
    auto taken = clicked ? feed.next_in_turn(after, longest_frame_wait) : feed.next(after, longest_frame_wait);
    const Result<camera::StereoFrame> frame = co_await taken;
    if (!frame) co_return fail(frame);
    after = frame->captured;
    const GreyPair grey = grey_pair(*frame);
    StereoSight sight(grey.left, grey.right, *feed.model());
    const Result<void> fed = learner->feed(sight);
    if (!fed) co_return fail(fed);
  }
  co_return learner->sample();
}

Task<Result<Datum>> VisionAgent::State::find(Asked asked) {
  const auto& [client, operation, name, came] = asked;
  co_await let_tracking_look();
  co_await begin_finding(client);
  // Another agent may just have forgotten or renamed it.
  co_await follow_memory();
  const Result<SeenMark> found = co_await find_mark(name, came);
  co_await end_finding(client);
  if (found) co_return list(find_reply(name, found->centre));
  const std::string text = find_reply(name, std::nullopt);
  const Result<Datum> answer = co_await answer_failed(text, found.error());
  co_return answer;
}

Task<Result<SeenMark>> VisionAgent::State::find_mark(std::string name, Time asked) {
  if (objects.find(name) == nullptr) co_return fail(not_known(name));
  Failure why;
  Time after = asked;
  for (int i = 0; i < frames_to_find; ++i) {
    const Result<camera::StereoFrame> frame = co_await feed.next(after, longest_frame_wait);
    if (!frame) co_return fail(frame);
    after = frame->captured;
    tracking_is_next = tracking_is_next || frame->left != tracked_image;
    // It may have been forgotten meanwhile.
    const LearnedObject* object = objects.find(name);
    if (object == nullptr) co_return fail(not_known(name));
    const GreyPair grey = grey_pair(*frame);
    StereoSight sight(grey.left, grey.right, *feed.model());
    const Result<FoundMark> found = finder.find(sight, *object, context.executor.now());
    begin_showing(*frame, {});
    if (!found) why = found.error();
    if (!found) continue;
    std::vector<Datum> told{found_fact(frame->number, *found)};
    co_await facts.tell(std::move(told));
    co_return found->pair.left;
  }
  co_return fail(why);
}

Task<Result<Datum>> VisionAgent::State::track(Asked asked) {
  const std::string holder = co_await holder_for(asked.client);
  const LearnedObject* object = objects.find(asked.name);
  if (object == nullptr) co_return fail(not_known(asked.name));
  if (!holders.tracked().contains(object->name)) tracking_asked = asked.came;
  const LearnedObject* end_effector = objects.find(end_effector_name);
  for (const LearnedObject* each : {end_effector, object}) {
    if (each == nullptr) continue;
    const Result<void> added = tracker.add(*each, finder.place_of(each->name));
    if (!added) co_return fail(added);
    holders.track(holder, each->name);
  }
  holders.connect(holder);
  feed.start();
  co_await tell_state();
  co_return Datum();
}

Task<Result<Datum>> VisionAgent::State::end_track(Asked asked) {
  if (holders.tracker().empty()) co_return Datum();
  if (!holders.tracks(asked.client)) {
    const std::string holder = holders.tracker();
    co_return fail("busy", fmt::format("{} tracks, and ends it itself", holder), Datum::symbol(holder));
  }
  holders.end_track(asked.client);
  co_await follow_holders();
  co_return Datum();
}

Task<Result<Datum>> VisionAgent::State::connect(Asked asked) {
  const std::string holder = co_await holder_for(asked.client);
  holders.connect(holder);
  feed.start();
  co_await tell_state();
  co_return Datum();
}

Task<Result<Datum>> VisionAgent::State::disconnect(Asked asked) {
  holders.disconnect(asked.client);
  co_await follow_holders();
  co_return Datum();
}

Task<Result<Datum>> VisionAgent::State::keep_modes(Asked asked) {
  const std::string holder = co_await holder_for(asked.client);
  if (!holders.keep(holder)) co_return fail("nothing-held", "the client is neither connected nor tracking", "keep"_sym);
  co_await tell_holders();
  co_return Datum();
}

Task<Result<Datum>> VisionAgent::State::get_objects(Asked) {
  co_await follow_memory();
  co_return list(get_reply(objects));
}

}  // namespace pizarra::vision
