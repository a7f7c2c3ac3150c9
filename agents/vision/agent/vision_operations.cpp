#include "agents/vision/agent/vision_operations.hpp"

#include <algorithm>
#include <cassert>
#include <fmt/format.h>

#include "agents/vision/agent/reply_text.hpp"
#include "agents/vision/agent/search_request.hpp"

namespace pizarra::vision {
namespace {

// Checks the names of the client and of the objects: all strings are names of objects.
Result<void> check_names(const Fact& request) {
  Result<void> good = ModeHolders::check_client(request.teller);
  for (const Datum& argument : request.datum[3].items()) {
    if (good && argument.is_string()) good = check_object_name(argument.text());
  }
  return good;
}

}  // namespace

const VisionOperations::Operation& VisionOperations::operation_called(std::string_view word) {
  using enum TurnQueue::Kind;
  static constexpr Operation operations[] = {
      {.word = "learn", .turn = learning, .run = &VisionOperations::learn},
      {.word = "find", .turn = beside, .run = &VisionOperations::find},
      {.word = "track", .turn = brief, .run = &VisionOperations::track},
      {.word = "end-track", .turn = beside, .run = &VisionOperations::end_track},
      {.word = "get-objects", .turn = {}, .run = &VisionOperations::get_objects},
      {.word = "connect", .turn = beside, .run = &VisionOperations::connect},
      {.word = "disconnect", .turn = beside, .run = &VisionOperations::disconnect},
      {.word = "keep", .turn = beside, .run = &VisionOperations::keep_modes},
      {.word = "accept", .turn = beside, .run = &VisionOperations::accept},
      {.word = "reject", .turn = beside, .run = &VisionOperations::reject},
      {.word = "forget", .turn = brief, .run = &VisionOperations::forget},
      {.word = "rename", .turn = brief, .run = &VisionOperations::rename},
      {.word = "learn-from", .turn = brief, .run = &VisionOperations::learn_from},
      {.word = "search-in", .turn = beside, .run = &VisionOperations::search_in},
      {.word = "search-everywhere", .turn = beside, .run = &VisionOperations::search_everywhere},
      {.word = "look-at-most", .turn = beside, .run = &VisionOperations::look_at_most},
      {.word = "look-always", .turn = beside, .run = &VisionOperations::look_always},
      {.word = "define-body", .turn = brief, .run = &VisionOperations::define_body},
      {.word = "forget-body", .turn = brief, .run = &VisionOperations::forget_body},
  };
  const auto found = std::ranges::find(operations, word, &Operation::word);
  assert(found != std::end(operations) && "the contract offers no others");
  return *found;
}

Task<Result<Datum>> VisionOperations::handle(Fact request) {
  const Time came = eyes_.context.executor.now();
  const Datum& asked_for = request.datum[3];
  const Operation& operation = operation_called(asked_for.head());
  const Result<void> named = check_names(request);
  if (!named) co_return fail(named);
  Result<std::unique_ptr<ClientTurns::Turn>> turn;
  if (operation.turn) turn = co_await eyes_.turns.take(request.teller, *operation.turn);
  if (!turn) co_return fail(turn);
  const std::string name = asked_for.size() > 1 ? std::string(asked_for.items().back().text()) : "";
  Asked asked{request.teller, asked_for, name, came};
  const Result<Datum> answer = co_await (this->*operation.run)(std::move(asked));
  co_return answer;
}

Task<Result<Datum>> VisionOperations::learn(Asked asked) {
  const auto& [client, operation, name, came] = asked;
  const Result<void> free = eyes_.bodies.check_name(name);
  if (!free) co_return fail(free);
  eyes_.holders.begin_learning(client);
  eyes_.feed.start();
  co_await eyes_.state.tell();
  const cv::Point2d click(operation[1].number(), operation[2].number());
  std::optional<std::uint64_t> clicked;
  if (operation.size() > 4) clicked = static_cast<std::uint64_t>(std::max<std::int64_t>(0, operation[3].integer()));
  Result<LearnedSample> sample = co_await eyes_.search.learn(name, click, clicked, came);
  Result<void> kept = sample ? Result<void>() : fail(sample);
  if (sample) kept = co_await eyes_.known.keep(client, name, std::move(*sample));
  eyes_.holders.end_learning();
  eyes_.search.forget_learning();
  co_await eyes_.rest_or_go_on();
  if (kept) co_return list(learn_reply(name, true));
  const std::string text = learn_reply(name, false);
  const Result<Datum> answer = co_await eyes_.answer_failed(text, kept.error());
  co_return answer;
}

Task<Result<Datum>> VisionOperations::find(Asked asked) {
  const auto& [client, operation, name, came] = asked;
  const Time deadline = eyes_.context.executor.now() + ClientTurns::longest_wait;
  if (!eyes_.tracker.empty()) co_await eyes_.tracking_turn.let_look(deadline);
  eyes_.holders.begin_finding(client);
  eyes_.feed.start();
  co_await eyes_.state.tell();
  // Another agent may just have forgotten or renamed it.
  co_await eyes_.known.follow_memory();
  const std::set<std::string> marks = eyes_.bodies.marks_of({name});
  const Result<FoundMark> found = co_await eyes_.search.find(name, marks, came);
  if (found) {
    std::vector<Datum> told{found_fact(eyes_.feed.frame_number(), *found)};
    co_await eyes_.facts.tell(std::move(told));
  }
  eyes_.holders.end_finding(client);
  co_await eyes_.rest_or_go_on();
  if (found) co_return list(find_reply(name, found->pair.left.centre));
  const std::string text = find_reply(name, std::nullopt);
  const Result<Datum> answer = co_await eyes_.answer_failed(text, found.error());
  co_return answer;
}

Task<Result<Datum>> VisionOperations::track(Asked asked) {
  const std::string holder = co_await eyes_.presence.holder_for(asked.client);
  const Result<std::vector<const LearnedObject*>> objects = meant_by(asked.name);
  if (!objects) co_return fail(objects);
  const std::set<std::string> tracked = eyes_.bodies.marks_of(eyes_.holders.tracked());
  for (const LearnedObject* each : *objects) {
    if (!tracked.contains(each->name)) eyes_.tracking_turn.look_only_after(asked.came);
    const Result<void> added = eyes_.tracker.add(*each, eyes_.search.place_of(each->name));
    if (!added) co_return fail(added);
  }
  const Body* body = eyes_.bodies.find(asked.name);
  if (body != nullptr) eyes_.holders.track(holder, body->name);
  for (const LearnedObject* each : *objects) {
    const bool is_of_body = body != nullptr && body->mark(each->name) != nullptr;
    if (!is_of_body) eyes_.holders.track(holder, each->name);
  }
  eyes_.holders.connect(holder);
  eyes_.feed.start();
  co_await eyes_.state.tell();
  co_return Datum();
}

Result<std::vector<const LearnedObject*>> VisionOperations::meant_by(const std::string& name) const {
  std::vector<const LearnedObject*> out;
  const std::set<std::string> marks = eyes_.bodies.marks_of({name});
  for (const std::string& mark : marks) {
    const LearnedObject* object = eyes_.known.objects().find(mark);
    if (object != nullptr) out.push_back(object);
  }
  if (out.empty()) return fail(eyes_.known.not_known(name));
  const LearnedObject* end_effector = eyes_.known.objects().find(end_effector_name);
  if (end_effector != nullptr) out.insert(out.begin(), end_effector);
  return out;
}

Task<Result<Datum>> VisionOperations::end_track(Asked asked) {
  if (eyes_.holders.tracker().empty()) co_return Datum();
  if (!eyes_.holders.tracks(asked.client)) {
    const std::string holder = eyes_.holders.tracker();
    co_return fail("busy", fmt::format("{} tracks, and ends it itself", holder), Datum::symbol(holder));
  }
  eyes_.holders.end_track(asked.client);
  co_await eyes_.follow_holders();
  co_return Datum();
}

Task<Result<Datum>> VisionOperations::connect(Asked asked) {
  const std::string holder = co_await eyes_.presence.holder_for(asked.client);
  eyes_.holders.connect(holder);
  eyes_.feed.start();
  co_await eyes_.state.tell();
  co_return Datum();
}

Task<Result<Datum>> VisionOperations::disconnect(Asked asked) {
  eyes_.holders.disconnect(asked.client);
  co_await eyes_.follow_holders();
  co_return Datum();
}

Task<Result<Datum>> VisionOperations::keep_modes(Asked asked) {
  const std::string holder = co_await eyes_.presence.holder_for(asked.client);
  if (!eyes_.holders.keep(holder))
    co_return fail("nothing-held", "the client is neither connected nor tracking", "keep"_sym);
  co_await eyes_.state.tell_holders();
  co_return Datum();
}

Task<Result<Datum>> VisionOperations::get_objects(Asked) {
  co_await eyes_.known.follow_memory();
  co_return list(get_reply(eyes_.bodies.names()));
}

// A body goes by the names of its marks.
Task<Result<Datum>> VisionOperations::forget(Asked asked) {
  const Result<void> free = eyes_.bodies.check_no_mark(asked.name);
  if (!free) co_return fail(free);
  const Result<Datum> forgotten = co_await eyes_.known.forget(asked.client, asked.name);
  co_return forgotten;
}

Task<Result<Datum>> VisionOperations::rename(Asked asked) {
  const std::string was(asked.operation[1].text());
  const Result<void> free = eyes_.bodies.check_no_mark(was);
  if (!free) co_return fail(free);
  const Result<void> unused = eyes_.bodies.check_name(asked.name);
  if (!unused) co_return fail(unused);
  const Result<Datum> renamed = co_await eyes_.known.rename(asked.client, was, asked.name);
  co_return renamed;
}

Task<Result<Datum>> VisionOperations::learn_from(Asked asked) {
  const Result<Datum> learned = co_await eyes_.known.learn_from(asked.name);
  if (!learned) co_return learned;
  const Result<void> defined = co_await eyes_.bodies.learn_from(asked.name);
  if (!defined) co_return fail(defined);
  co_return learned;
}

Task<Result<Datum>> VisionOperations::search_in(Asked asked) {
  std::optional<cv::Size> image;
  if (eyes_.feed.model()) image = cv::Size(eyes_.feed.model()->width, eyes_.feed.model()->height);
  const Result<cv::Rect> area = area_in(asked.operation, image);
  if (!area) co_return fail(area);
  std::function<void(SearchLimit&)> change = [area](SearchLimit& limit) { limit.area = *area; };
  const Result<Datum> done = co_await eyes_.known.limit(asked.client, asked.name, std::move(change));
  co_return done;
}

Task<Result<Datum>> VisionOperations::search_everywhere(Asked asked) {
  return eyes_.known.limit(asked.client, asked.name, [](SearchLimit& limit) { limit.area.reset(); });
}

Task<Result<Datum>> VisionOperations::look_at_most(Asked asked) {
  const Result<double> rate = rate_in(asked.operation);
  if (!rate) co_return fail(rate);
  std::function<void(SearchLimit&)> change = [rate](SearchLimit& limit) { limit.per_second = *rate; };
  const Result<Datum> done = co_await eyes_.known.limit(asked.client, asked.name, std::move(change));
  co_return done;
}

Task<Result<Datum>> VisionOperations::look_always(Asked asked) {
  return eyes_.known.limit(asked.client, asked.name, [](SearchLimit& limit) { limit.per_second.reset(); });
}

}  // namespace pizarra::vision
