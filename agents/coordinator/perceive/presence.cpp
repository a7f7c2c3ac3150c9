#include "agents/coordinator/perceive/presence.hpp"

#include "agents/coordinator/perceive/follow.hpp"

namespace pizarra::coordinator {

void Presence::start() {
  const Datum any = "?"_sym;
  const auto take_change = [this](Change change) { return take(std::move(change)); };
  following_ = context_.executor.spawn(follow(context_, list("agent"_sym, any, any, any), take_change));
}

Task<void> Presence::take(Change change) {
  if (change.resynchronised) present_.clear();
  for (const Answer& answer : change.removed) present_.erase(std::string(answer.facts.front().datum[1].text()));
  for (const Answer& answer : change.added) present_.emplace(answer.facts.front().datum[1].text());
  changed_.wake_all();
  co_return;
}

Task<bool> Presence::wait_for(std::string agent, Time deadline) {
  while (!has(agent)) {
    const bool woken = co_await changed_.wait(deadline);
    if (!woken) co_return has(agent);
  }
  co_return true;
}

}  // namespace pizarra::coordinator
