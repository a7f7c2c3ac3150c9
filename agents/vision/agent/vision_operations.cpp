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
  const Result<FoundMark> found = co_await search.find(name, came);
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
  const LearnedObject* object = known.objects().find(asked.name);
  if (object == nullptr) co_return fail(known.not_known(asked.name));
  if (!holders.tracked().contains(object->name)) tracking_turn.look_only_after(asked.came);
  const LearnedObject* end_effector = known.objects().find(end_effector_name);
  for (const LearnedObject* each : {end_effector, object}) {
    if (each == nullptr) continue;
    const Result<void> added = tracker.add(*each, search.place_of(each->name));
    if (!added) co_return fail(added);
    holders.track(holder, each->name);
  }
  holders.connect(holder);
  feed.start();
  co_await state.tell();
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
  co_return list(get_reply(known.objects()));
}

Task<Result<Datum>> VisionAgent::State::rename(Asked asked) {
  return known.rename(asked.client, std::string(asked.operation[1].text()), asked.name);
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
