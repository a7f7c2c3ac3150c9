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

Result<FoundMark> MarkSearch::find_in(const camera::StereoFrame& frame, const std::string& name,
                                      const std::set<std::string>& marks) {
  StereoSight sight(frame, *feed_.model());
  ConfinedSights sights(sight);
  // They may have been forgotten meanwhile.
  Result<FoundMark> out = fail(known_.not_known(name));
  for (const std::string& mark : marks) {
    const LearnedObject* object = known_.objects().find(mark);
    if (object == nullptr) continue;
    const std::optional<cv::Rect> area = known_.limits().of(object->name).area;
    Result<FoundMark> found = finder_.find(sights.of(area), *object, executor_.now());
    if (!found && area) found.error().sentence += "; it was looked for in its area alone";
    const bool is_surer = !out || (found && found->confidence > out->confidence);
    if (is_surer) out = std::move(found);
  }
  return out;
}

Task<Result<FoundMark>> MarkSearch::find(std::string name, std::set<std::string> marks, Time asked) {
  const auto is_known = [&](const std::string& mark) { return known_.objects().find(mark) != nullptr; };
  if (std::ranges::none_of(marks, is_known)) co_return fail(known_.not_known(name));
  Failure why;
  Time after = asked;
  for (int i = 0; i < frames_to_find; ++i) {
    const Result<camera::StereoFrame> frame = co_await feed_.next(after, longest_frame_wait);
    if (!frame) co_return fail(frame);
    after = frame->captured;
    const Result<FoundMark> found = find_in(*frame, name, marks);
    on_find_look_(*frame);
    if (found) co_return found;
    why = found.error();
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
