// What a client asks of the eyes.

#include <algorithm>
#include <cassert>
#include <fmt/format.h>

#include "agents/vision/agent/reply_text.hpp"
#include "agents/vision/agent/search_request.hpp"
#include "agents/vision/agent/vision_state.hpp"

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

const VisionAgent::State::Operation& VisionAgent::State::operation_called(std::string_view word) {
  using enum TurnQueue::Kind;
  static constexpr Operation operations[] = {
      {.word = "learn", .turn = learning, .run = &State::learn},
      {.word = "find", .turn = beside, .run = &State::find},
      {.word = "track", .turn = brief, .run = &State::track},
      {.word = "end-track", .turn = beside, .run = &State::end_track},
      {.word = "get-objects", .turn = {}, .run = &State::get_objects},
      {.word = "connect", .turn = beside, .run = &State::connect},
      {.word = "disconnect", .turn = beside, .run = &State::disconnect},
      {.word = "keep", .turn = beside, .run = &State::keep_modes},
      {.word = "accept", .turn = beside, .run = &State::accept},
      {.word = "reject", .turn = beside, .run = &State::reject},
      {.word = "forget", .turn = brief, .run = &State::forget},
      {.word = "rename", .turn = brief, .run = &State::rename},
      {.word = "learn-from", .turn = brief, .run = &State::learn_from},
      {.word = "search-in", .turn = beside, .run = &State::search_in},
      {.word = "search-everywhere", .turn = beside, .run = &State::search_everywhere},
      {.word = "look-at-most", .turn = beside, .run = &State::look_at_most},
      {.word = "look-always", .turn = beside, .run = &State::look_always},
      {.word = "define-body", .turn = brief, .run = &State::define_body},
      {.word = "forget-body", .turn = brief, .run = &State::forget_body},
  };
  const auto found = std::ranges::find(operations, word, &Operation::word);
  assert(found != std::end(operations) && "the contract offers no others");
  return *found;
}

Task<Result<Datum>> VisionAgent::State::handle(Fact request) {
  const Time came = context.executor.now();
  const Datum& asked_for = request.datum[3];
  const Operation& operation = operation_called(asked_for.head());
  const Result<void> named = check_names(request);
  if (!named) co_return fail(named);
  Result<std::unique_ptr<ClientTurns::Turn>> turn;
  if (operation.turn) turn = co_await turns.take(request.teller, *operation.turn);
  if (!turn) co_return fail(turn);
  const std::string name = asked_for.size() > 1 ? std::string(asked_for.items().back().text()) : "";
  Asked asked{request.teller, asked_for, name, came};
  const Result<Datum> answer = co_await (this->*operation.run)(std::move(asked));
  co_return answer;
}

Task<Result<Datum>> VisionAgent::State::answer_failed(std::string text, Failure why) {
  const Datum symbol = Datum::symbol(why.symbol);
  const std::string sentence = describe(why);
  std::vector<Datum> failed{list("vision-failed"_sym, feed.frame_number(), text, symbol, sentence)};
  co_await facts.tell(std::move(failed));
  co_return list(text, symbol, sentence);
}

Task<Result<Datum>> VisionAgent::State::learn(Asked asked) {
  const auto& [client, operation, name, came] = asked;
  const Result<void> free = bodies.check_name(name);
  if (!free) co_return fail(free);
  holders.begin_learning(client);
  feed.start();
  co_await state.tell();
  const cv::Point2d click(operation[1].number(), operation[2].number());
  std::optional<std::uint64_t> clicked;
  if (operation.size() > 4) clicked = static_cast<std::uint64_t>(std::max<std::int64_t>(0, operation[3].integer()));
  Result<LearnedSample> sample = co_await search.learn(name, click, clicked, came);
  Result<void> kept = sample ? Result<void>() : fail(sample);
  if (sample) kept = co_await known.keep(client, name, std::move(*sample));
  holders.end_learning();
  search.forget_learning();
  co_await rest_or_go_on();
  if (kept) co_return list(learn_reply(name, true));
  const std::string text = learn_reply(name, false);
  const Result<Datum> answer = co_await answer_failed(text, kept.error());
  co_return answer;
}

Task<Result<Datum>> VisionAgent::State::find(Asked asked) {
  const auto& [client, operation, name, came] = asked;
  const Time deadline = context.executor.now() + ClientTurns::longest_wait;
  if (!tracker.empty()) co_await tracking_turn.let_look(deadline);
  holders.begin_finding(client);
  feed.start();
  co_await state.tell();
  // Another agent may just have forgotten or renamed it.
  co_await known.follow_memory();
  const std::set<std::string> marks = bodies.marks_of({name});
  const Result<FoundMark> found = co_await search.find(name, marks, came);
  if (found) {
    std::vector<Datum> told{found_fact(feed.frame_number(), *found)};
    co_await facts.tell(std::move(told));
  }
  holders.end_finding(client);
  co_await rest_or_go_on();
  if (found) co_return list(find_reply(name, found->pair.left.centre));
  const std::string text = find_reply(name, std::nullopt);
  const Result<Datum> answer = co_await answer_failed(text, found.error());
  co_return answer;
}

Task<Result<Datum>> VisionAgent::State::track(Asked asked) {
  const std::string holder = co_await presence.holder_for(asked.client);
  const Result<std::vector<const LearnedObject*>> objects = meant_by(asked.name);
  if (!objects) co_return fail(objects);
  const std::set<std::string> tracked = bodies.marks_of(holders.tracked());
  for (const LearnedObject* each : *objects) {
    if (!tracked.contains(each->name)) tracking_turn.look_only_after(asked.came);
    const Result<void> added = tracker.add(*each, search.place_of(each->name));
    if (!added) co_return fail(added);
  }
  const Body* body = bodies.find(asked.name);
  if (body != nullptr) holders.track(holder, body->name);
  for (const LearnedObject* each : *objects) {
    const bool is_of_body = body != nullptr && body->mark(each->name) != nullptr;
    if (!is_of_body) holders.track(holder, each->name);
  }
  holders.connect(holder);
  feed.start();
  co_await state.tell();
  co_return Datum();
}

Result<std::vector<const LearnedObject*>> VisionAgent::State::meant_by(const std::string& name) const {
  std::vector<const LearnedObject*> out;
  const std::set<std::string> marks = bodies.marks_of({name});
  for (const std::string& mark : marks) {
    const LearnedObject* object = known.objects().find(mark);
    if (object != nullptr) out.push_back(object);
  }
  if (out.empty()) return fail(known.not_known(name));
  const LearnedObject* end_effector = known.objects().find(end_effector_name);
  if (end_effector != nullptr) out.insert(out.begin(), end_effector);
  return out;
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
  const std::string holder = co_await presence.holder_for(asked.client);
  holders.connect(holder);
  feed.start();
  co_await state.tell();
  co_return Datum();
}

Task<Result<Datum>> VisionAgent::State::disconnect(Asked asked) {
  holders.disconnect(asked.client);
  co_await follow_holders();
  co_return Datum();
}

Task<Result<Datum>> VisionAgent::State::keep_modes(Asked asked) {
  const std::string holder = co_await presence.holder_for(asked.client);
  if (!holders.keep(holder)) co_return fail("nothing-held", "the client is neither connected nor tracking", "keep"_sym);
  co_await state.tell_holders();
  co_return Datum();
}

Task<Result<Datum>> VisionAgent::State::get_objects(Asked) {
  co_await known.follow_memory();
  co_return list(get_reply(bodies.names()));
}

// A body goes by the names of its marks.
Task<Result<Datum>> VisionAgent::State::forget(Asked asked) {
  const Result<void> free = bodies.check_no_mark(asked.name);
  if (!free) co_return fail(free);
  const Result<Datum> forgotten = co_await known.forget(asked.client, asked.name);
  co_return forgotten;
}

Task<Result<Datum>> VisionAgent::State::rename(Asked asked) {
  const std::string was(asked.operation[1].text());
  const Result<void> free = bodies.check_no_mark(was);
  if (!free) co_return fail(free);
  const Result<void> unused = bodies.check_name(asked.name);
  if (!unused) co_return fail(unused);
  const Result<Datum> renamed = co_await known.rename(asked.client, was, asked.name);
  co_return renamed;
}

Task<Result<Datum>> VisionAgent::State::learn_from(Asked asked) {
  const Result<Datum> learned = co_await known.learn_from(asked.name);
  if (!learned) co_return learned;
  const Result<void> defined = co_await bodies.learn_from(asked.name);
  if (!defined) co_return fail(defined);
  co_return learned;
}

Task<Result<Datum>> VisionAgent::State::search_in(Asked asked) {
  std::optional<cv::Size> image;
  if (feed.model()) image = cv::Size(feed.model()->width, feed.model()->height);
  const Result<cv::Rect> area = area_in(asked.operation, image);
  if (!area) co_return fail(area);
  std::function<void(SearchLimit&)> change = [area](SearchLimit& limit) { limit.area = *area; };
  const Result<Datum> done = co_await known.limit(asked.client, asked.name, std::move(change));
  co_return done;
}

Task<Result<Datum>> VisionAgent::State::search_everywhere(Asked asked) {
  return known.limit(asked.client, asked.name, [](SearchLimit& limit) { limit.area.reset(); });
}

Task<Result<Datum>> VisionAgent::State::look_at_most(Asked asked) {
  const Result<double> rate = rate_in(asked.operation);
  if (!rate) co_return fail(rate);
  std::function<void(SearchLimit&)> change = [rate](SearchLimit& limit) { limit.per_second = *rate; };
  const Result<Datum> done = co_await known.limit(asked.client, asked.name, std::move(change));
  co_return done;
}

Task<Result<Datum>> VisionAgent::State::look_always(Asked asked) {
  return known.limit(asked.client, asked.name, [](SearchLimit& limit) { limit.per_second.reset(); });
}

}  // namespace pizarra::vision
