// Who may use the eyes for what, and when.

#include <algorithm>
#include <fmt/format.h>

#include "agents/vision/agent/vision_state.hpp"

namespace pizarra {
namespace {

// A learning takes two seconds, a finding a few frames.
constexpr Duration longest_wait_for_turn = 6s;
constexpr std::size_t most_waiting = 64;
constexpr std::size_t most_waiting_of_one = 8;
// Of who is not present.
constexpr Duration lease = 60s;

Datum presence_of(Datum who) { return list("agent"_sym, std::move(who), "?"_sym, "?"_sym); }

}  // namespace

Task<std::string> VisionAgent::State::holder_for(std::string client) {
  const Datum pattern = presence_of(Datum::symbol(client));
  const Result<std::vector<Fact>> present = co_await context.board.facts(pattern);
  const bool here = present && !present->empty();
  if (here) co_return client;
  absent_until = context.executor.now() + lease;
  co_return std::string(ModeHolders::absent);
}

Result<void> VisionAgent::State::check_free(Activity allowed) const {
  if (activity == Activity::none || activity == allowed) return {};
  const std::string holder = activity == Activity::tracking ? holders.tracker() : busy_for;
  return fail("busy", fmt::format("vision is {} for {}", mode(), holder), Datum::symbol(holder));
}

Result<void> VisionAgent::State::check_untracked(const std::string& client, const std::string& name) const {
  const std::string holder = holders.other_tracker(client, name);
  if (holder.empty()) return {};
  return fail("busy", fmt::format("{} tracks it, which is then not changed by others", holder), Datum::symbol(holder));
}

Result<void> VisionAgent::State::check_room_to_wait(const std::string& client) const {
  const auto own = std::ranges::count(turns, client, &Turn::client);
  if (own >= static_cast<std::ptrdiff_t>(most_waiting_of_one)) {
    return fail("busy", fmt::format("{} requests of {} wait already", own, client), Datum::symbol(client));
  }
  if (turns.size() < most_waiting) return {};
  return fail("busy", "vision is asked for too much at once", Datum::symbol(busy_for));
}

Task<Result<void>> VisionAgent::State::take_turn(std::string client, Activity allowed) {
  const Result<void> room = check_room_to_wait(client);
  if (!room) co_return room;
  const int mine = ++last_turn;
  turns.push_back({mine, std::move(client)});
  // However the waiting ends, the next one's turn comes.
  struct Leaving {
    State& state;
    int turn;
    ~Leaving() {
      std::erase_if(state.turns, [this](const Turn& each) { return each.number == turn; });
      state.turn_ended.wake_all();
    }
  };
  const Leaving leaving{*this, mine};
  const Time deadline = context.executor.now() + longest_wait_for_turn;
  Result<void> free = check_free(allowed);
  bool in_time = true;
  while (in_time) {
    free = check_free(allowed);
    const bool next = turns.front().number == mine;
    // Others' tracking may last for ever.
    const bool hopeless = !free && activity == Activity::tracking;
    const bool over = (free && next) || hopeless;
    if (over) co_return free;
    in_time = co_await turn_ended.wait(deadline);
  }
  if (!free) co_return free;
  co_return fail("busy", "vision is asked for too much at once", Datum::symbol(busy_for));
}

Task<void> VisionAgent::State::begin(Activity wanted, std::string client) {
  activity = wanted;
  busy_for = std::move(client);
  feed.start();
  co_await tell_state();
}

Task<void> VisionAgent::State::finish_activity() {
  activity = tracker.empty() ? Activity::none : Activity::tracking;
  learner.reset();
  turn_ended.wake_all();
  if (activity == Activity::none && !holders.connected()) feed.stop();
  co_await tell_state();
}

Task<void> VisionAgent::State::follow_holders() {
  const std::set<std::string> tracked = holders.tracked();
  tracker.keep_only(tracked);
  const bool ended = activity == Activity::tracking && tracker.empty();
  if (ended) activity = Activity::none;
  if (ended) turn_ended.wake_all();
  if (activity == Activity::none && !holders.connected()) feed.stop();
  co_await tell_state();
  if (!tracker.empty() && holders.connected()) co_return;
  co_await facts.unsay();
}

Task<void> VisionAgent::State::let_dead_go() {
  const bool lapsed = context.executor.now() >= absent_until && holders.let_go(std::string(ModeHolders::absent));
  if (lapsed) co_await follow_holders();
  const std::vector<std::string> clients = holders.clients();
  if (clients.empty()) co_return;
  const Datum anyone = presence_of("?"_sym);
  const Result<std::vector<Fact>> present = co_await context.board.facts(anyone);
  if (!present) co_return;
  std::set<std::string> now_missing;
  bool let_go = false;
  for (const std::string& client : clients) {
    const bool here = std::ranges::any_of(*present, [&](const Fact& fact) { return fact.datum[1].text() == client; });
    if (here) continue;
    if (missing.contains(client)) {
      holders.let_go(client);
      let_go = true;
    } else {
      now_missing.insert(client);
    }
  }
  missing = std::move(now_missing);
  if (let_go) co_await follow_holders();
}

}  // namespace pizarra
