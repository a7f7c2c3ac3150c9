#include <filesystem>
#include <fmt/format.h>
#include <opencv2/imgcodecs.hpp>

#include "agents/vision/vision_replies.hpp"
#include "agents/vision/vision_state.hpp"

namespace pizarra {
namespace {

constexpr Duration longest_frame_wait = 3s;
constexpr int frames_to_find = 3;

}  // namespace

Result<void> VisionAgent::State::check_free(Activity allowed) const {
  if (activity == Activity::none || activity == allowed) return {};
  return fail("busy", fmt::format("vision is {}", mode()), Datum::symbol(mode()));
}

Task<void> VisionAgent::State::finish_activity() {
  activity = tracker.empty() ? Activity::none : Activity::tracking;
  learner.reset();
  if (activity == Activity::none && !connected) feed.stop();
  co_await tell_state();
}

Task<Result<Datum>> VisionAgent::State::answer_failed(std::string text, std::string reason) {
  std::vector<Datum> facts;
  facts.push_back(list("vision-failed"_sym, feed.frame_number(), text, reason));
  co_await tell(std::move(facts));
  co_return list(text);
}

Task<Result<Datum>> VisionAgent::State::learn(double x, double y, std::string name) {
  const Result<void> good_name = check_object_name(name);
  if (!good_name) co_return fail(good_name);
  const Result<void> free = check_free(Activity::none);
  if (!free) co_return fail(free);
  activity = Activity::learning;
  feed.start();
  co_await tell_state();
  Result<LearnedSample> sample = co_await learn_sample(name, x, y);
  Result<void> kept;
  if (sample) kept = co_await keep(name, std::move(*sample));
  co_await finish_activity();
  if (sample && kept) co_return list(learn_reply(name, true));
  const std::string reason = sample ? describe(kept.error()) : describe(sample.error());
  const std::string text = learn_reply(name, false);
  const Result<Datum> answer = co_await answer_failed(text, reason);
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

// Known only once the board has it.
Task<Result<void>> VisionAgent::State::keep(std::string name, LearnedSample sample) {
  const Result<LearnedObjects::Slot> slot = objects.slot_for(name);
  if (!slot) co_return fail(slot);
  sample.number = slot->number;
  const Result<void> written = write_template(slot->name, sample);
  if (!written) co_return written;
  Transaction transaction;
  transaction.tell(learned_fact(slot->name, sample)).tell(learned_template_fact(slot->name, sample));
  const Result<Revision> told = co_await context.board.transact(std::move(transaction));
  if (!told) co_return fail(told);
  objects.add(slot->name, std::move(sample));
  co_return Result<void>();
}

Result<void> VisionAgent::State::write_template(const std::string& name, const LearnedSample& sample) const {
  if (options.template_directory.empty()) return {};
  cv::Mat1b bitmap(template_size, template_size);
  std::ranges::transform(sample.picture, bitmap.begin(), [&](std::uint8_t level) {
    return static_cast<std::uint8_t>(sample.tone == MarkTone::dark ? 255 - 17 * level : 17 * level);
  });
  const std::filesystem::path directory = options.template_directory;
  const std::string path = directory / fmt::format("{}-{}.pgm", name, sample.number);
  std::error_code error;
  std::filesystem::create_directories(directory, error);
  bool written = false;
  try {
    written = !error && cv::imwrite(path, bitmap);
  } catch (const cv::Exception&) {
    written = false;
  }
  if (!written) return fail("template-not-written", "the template bitmap cannot be written", to_datum(path));
  return {};
}

Task<Result<Datum>> VisionAgent::State::find(std::string name) {
  const Result<void> free = check_free(Activity::tracking);
  if (!free) co_return fail(free);
  activity = Activity::finding;
  feed.start();
  co_await tell_state();
  const Result<SeenMark> found = co_await find_mark(name);
  co_await finish_activity();
  if (found) co_return list(find_reply(name, found->centre));
  const std::string text = find_reply(name, std::nullopt);
  const std::string reason = describe(found.error());
  const Result<Datum> answer = co_await answer_failed(text, reason);
  co_return answer;
}

Task<Result<SeenMark>> VisionAgent::State::find_mark(std::string name) {
  const LearnedObject* object = objects.find(name);
  if (object == nullptr) co_return fail("not-learned", "nothing is learned under this name", to_datum(name));
  for (int i = 0; i < frames_to_find; ++i) {
    const Result<StereoFrame> frame = co_await feed.next(longest_frame_wait);
    if (!frame) co_return fail(frame);
    const GreyPair grey = grey_pair(*frame);
    StereoSight sight(grey.left, grey.right, *feed.model());
    const std::optional<SeenPair> found = sight.find(objects, *object);
    if (found) co_return found->left;
  }
  co_return fail("not-seen", "no mark in the image is like it", to_datum(name));
}

Task<Result<Datum>> VisionAgent::State::track(std::string name) {
  const Result<void> free = check_free(Activity::tracking);
  if (!free) co_return fail(free);
  const LearnedObject* object = objects.find(name);
  if (object == nullptr) co_return fail("not-learned", "nothing is learned under this name", to_datum(name));
  const LearnedObject* end_effector = objects.find(end_effector_name);
  if (end_effector != nullptr) {
    const Result<void> added = tracker.add(*end_effector);
    if (!added) co_return fail(added);
  }
  const Result<void> added = tracker.add(*object);
  if (!added) co_return fail(added);
  activity = Activity::tracking;
  connected = true;
  feed.start();
  co_await tell_state();
  co_return Datum();
}

Task<Result<Datum>> VisionAgent::State::end_track() {
  tracker.clear();
  if (activity == Activity::tracking) co_await finish_activity();
  const Result<void> unsaid = co_await unsay();
  if (!unsaid) co_return fail(unsaid);
  co_return Datum();
}

Task<Result<Datum>> VisionAgent::State::connect() {
  connected = true;
  feed.start();
  co_await tell_state();
  co_return Datum();
}

Task<Result<Datum>> VisionAgent::State::disconnect() {
  connected = false;
  if (activity == Activity::none) feed.stop();
  co_await tell_state();
  const Result<void> unsaid = co_await unsay();
  if (!unsaid) co_return fail(unsaid);
  co_return Datum();
}

Task<Result<Datum>> VisionAgent::State::get_objects() { co_return list(get_reply(objects)); }

}  // namespace pizarra
