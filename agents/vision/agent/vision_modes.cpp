// Who may use the eyes for what, and when.

#include <algorithm>
#include <fmt/format.h>

#include "agents/vision/agent/vision_state.hpp"

namespace pizarra::vision {
namespace {

Datum presence_of(Datum who) { return list("agent"_sym, std::move(who), "?"_sym, "?"_sym); }

}  // namespace

Task<Result<bool>> VisionAgent::State::is_present(std::string client) {
  const Datum pattern = presence_of(Datum::symbol(client));
  const Result<std::vector<Fact>> present = co_await context.board.facts(pattern);
  if (!present) co_return fail(present);
  co_return !present->empty();
}

Task<std::string> VisionAgent::State::holder_for(std::string client) {
  const Result<bool> present = co_await is_present(client);
  if (present.value_or(false)) co_return client;
  absent_until = context.executor.now() + ModeHolders::absent_for;
  co_return std::string(ModeHolders::absent);
}

Task<Result<void>> VisionAgent::State::check_judged(std::string client, std::string name) {
  const std::vector<std::string> judges = to_accept.other_judges(client, name, context.executor.now());
  for (const std::string& judge : judges) {
    const Result<bool> present = co_await is_present(judge);
    if (!present.value_or(true)) continue;
    co_return fail("busy",
                   fmt::format("{} has learned a sample of it, and is still to accept or to reject that", judge),
                   Datum::symbol(judge));
  }
  co_return {};
}

Result<void> VisionAgent::State::check_untracked(const std::string& client, const std::string& name) const {
  const std::string holder = holders.other_tracker(client, name);
  if (holder.empty()) return {};
  return fail("busy", fmt::format("{} tracks it, which is then not changed by others", holder), Datum::symbol(holder));
}

Task<Result<void>> VisionAgent::State::check_unheld(std::string client, std::string name) {
  const Result<void> untracked = check_untracked(client, name);
  if (!untracked) co_return untracked;
  const Result<void> judged = co_await check_judged(std::move(client), std::move(name));
  co_return judged;
}

Task<void> VisionAgent::State::begin_finding(std::string client) {
  finding_for.push_back(std::move(client));
  feed.start();
  co_await tell_state();
}

Task<void> VisionAgent::State::end_finding(std::string client) {
  std::erase(finding_for, client);
  co_await rest_or_go_on();
}

Task<void> VisionAgent::State::begin_learning(std::string client) {
  learning_for = std::move(client);
  feed.start();
  co_await tell_state();
}

Task<void> VisionAgent::State::end_learning() {
  learning_for.clear();
  learner.reset();
  co_await rest_or_go_on();
}

Task<void> VisionAgent::State::rest_or_go_on() {
  const bool busy = !learning_for.empty() || !finding_for.empty() || !tracker.empty() || !tags.empty();
  if (!busy && !holders.connected()) feed.stop();
  co_await tell_state();
}

Task<void> VisionAgent::State::follow_holders() {
  const std::set<std::string> tracked = holders.tracked();
  tracker.keep_only(tracked);
  turns_changed.wake_all();
  co_await rest_or_go_on();
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

}  // namespace pizarra::vision
