#include "agents/vision/agent/mark_search.hpp"

#include <algorithm>

namespace pizarra::vision {
namespace {

constexpr Duration longest_frame_wait = 3s;
constexpr int frames_to_find = 3;
constexpr Duration found_shown_for = 3s;

}  // namespace

Task<Result<LearnedSample>> MarkSearch::learn(std::string name, cv::Point2d click, std::optional<std::uint64_t> clicked,
                                              Time asked) {
  learner_.emplace(name, click, known_.objects());
  Time after = asked;
  if (clicked) {
    const Result<camera::StereoFrame> shown = feed_.kept(*clicked);
    if (!shown) co_return fail(shown);
    after = shown->captured - Duration(1);
  }
  while (!learner_->done()) {
    auto taken = clicked ? feed_.next_in_turn(after, longest_frame_wait) : feed_.next(after, longest_frame_wait);
    const Result<camera::StereoFrame> frame = co_await taken;
    if (!frame) co_return fail(frame);
    after = frame->captured;
    StereoSight sight(*frame, *feed_.model());
    const Result<void> fed = learner_->feed(sight);
    if (!fed) co_return fail(fed);
  }
  co_return learner_->sample();
}

Task<Result<FoundMark>> MarkSearch::find(std::string name, Time asked) {
  if (known_.objects().find(name) == nullptr) co_return fail(known_.not_known(name));
  Failure why;
  Time after = asked;
  for (int i = 0; i < frames_to_find; ++i) {
    const Result<camera::StereoFrame> frame = co_await feed_.next(after, longest_frame_wait);
    if (!frame) co_return fail(frame);
    after = frame->captured;
    // It may have been forgotten meanwhile.
    const LearnedObject* object = known_.objects().find(name);
    if (object == nullptr) co_return fail(known_.not_known(name));
    StereoSight sight(*frame, *feed_.model());
    ConfinedSights sights(sight);
    const std::optional<cv::Rect> area = known_.limits().of(object->name).area;
    Result<FoundMark> found = finder_.find(sights.of(area), *object, executor_.now());
    on_find_look_(*frame);
    if (found) co_return found;
    why = found.error();
    if (area) why.sentence += "; it was looked for in its area alone";
  }
  co_return fail(why);
}

void MarkSearch::add_to(Annotation& annotation) const {
  annotation.found = finder_.found_since(executor_.now() - found_shown_for);
  std::erase_if(annotation.found, [&](const FoundPlace& found) {
    return std::ranges::find(annotation.sightings, found.name, &TrackSighting::name) != annotation.sightings.end();
  });
  if (!learner_) return;
  annotation.learned_contour = learner_->contour();
  if (learner_->contour().empty()) annotation.filled = learner_->filled_so_far();
}

}  // namespace pizarra::vision
