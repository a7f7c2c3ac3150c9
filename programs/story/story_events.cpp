#include "programs/story/story_events.hpp"

#include <algorithm>
#include <cassert>
#include <fmt/format.h>

#include "agents/launcher/readiness.hpp"
#include "lisp/writer.hpp"

namespace pizarra::story {

namespace {

constexpr Duration hand_timeout = 20s;
constexpr Duration busy_pause = 200ms;
constexpr Duration end_pause = 100ms;

}  // namespace

void StoryEvents::begin() { job_ = cell_.executor().spawn(happen()); }

Task<bool> StoryEvents::end(Time deadline) {
  const bool disturbed = acting_;
  const std::size_t begun = done_ + (disturbed ? 1 : 0);
  while (acting_ && cell_.executor().now() < deadline) {
    co_await sleep(cell_.executor(), end_pause);
  }
  // Whether or not what comes behind its last action was still to be counted.
  if (!acting_) done_ = std::max(done_, begun);
  job_ = Job();
  co_return disturbed;
}

std::optional<Datum> StoryEvents::awaited() const {
  assert(done_ <= scenario_.events.size());
  if (done_ == scenario_.events.size()) return std::nullopt;
  return scenario_.events[done_].condition;
}

Task<Result<void>> StoryEvents::move_hand(Datum action) {
  const Time deadline = cell_.executor().now() + hand_timeout;
  narrator_.say(cell_.executor().now(), "hand", write(action), action);
  while (true) {
    const Result<simulation::Message> moved = co_await cell_.link().call(action, hand_timeout);
    if (moved) co_return {};
    if (moved.error().symbol != "busy" || cell_.executor().now() >= deadline) co_return fail(moved);
    co_await sleep(cell_.executor(), busy_pause);
  }
}

Task<Result<void>> StoryEvents::perform(Datum action) {
  if (action.is_form("wait")) {
    const auto pause = std::chrono::duration_cast<Duration>(std::chrono::duration<double>(action[1].number()));
    co_await sleep(cell_.executor(), pause);
    co_return {};
  }
  acting_ = true;
  const Result<void> done = co_await act(std::move(action));
  acting_ = false;
  co_return done;
}

Task<Result<void>> StoryEvents::ask_world(Datum action) {
  narrator_.say(cell_.executor().now(), "world", write(action), action);
  const Result<simulation::Message> done = co_await cell_.link().call(action, hand_timeout);
  if (!done) co_return fail(done);
  co_return {};
}

Task<Result<void>> StoryEvents::act(Datum action) {
  if (action.is_form("hand")) co_return co_await move_hand(action);
  const bool of_world = action.is_form("fingers") || action.is_form("camera") || action.is_form("head");
  if (of_world) co_return co_await ask_world(action);
  if (action.is_form("goal")) {
    std::vector<Datum> goal(action.items().begin() + 1, action.items().end());
    co_return co_await give_goal_(std::move(goal));
  }
  if (action.is_form("wire")) {
    narrator_.say(cell_.executor().now(), "agent",
                  fmt::format("{} is wired to {} as {}", action[3].text(), action[1].text(), action[2].text()), action);
    const Datum wired = list("wired"_sym, action[1], action[2], action[3]);
    const Result<Revision> told = co_await board_.tell(wired);
    if (!told) co_return fail(told);
    co_return Result<void>();
  }
  const std::string kind(action[1].text());
  narrator_.say(cell_.executor().now(), "agent", fmt::format("{} is {}ed", kind, action.head()), action);
  if (action.is_form("kill")) co_return cell_.kill(kind);
  const std::string host(action.size() > 2 ? action[2].text() : "localhost");
  co_return cell_.start(kind, host);
}

Task<void> StoryEvents::happen_once(forms::ScenarioEvent event) {
  Query query = query_from_datum(event.condition).value();
  const Time never = cell_.executor().now() + launcher::for_ever;
  const Result<Answer> come = co_await launcher::await_when_declared(board_, cell_.executor(), std::move(query), never);
  if (!come) {
    troubles_.push_back(describe(come.error()));
    co_return;
  }
  for (const Datum& action : event.actions) {
    Datum ground = substitute(action, come->bindings);
    const Result<void> done = co_await perform(std::move(ground));
    if (!done) troubles_.push_back(fmt::format("{}: {}", write(action), describe(done.error())));
  }
}

Task<void> StoryEvents::happen() {
  for (const forms::ScenarioEvent& event : scenario_.events) {
    co_await happen_once(event);
    ++done_;
  }
}

}  // namespace pizarra::story
