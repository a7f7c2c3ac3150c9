#include "agents/robot/holds.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "agents/runtime/follow.hpp"

namespace pizarra::robot {

namespace {

// This process may have been kept from running. So it reads what came meanwhile before it believes in a client's
// silence.
constexpr Duration second_look = 2ms;

}  // namespace

void Holds::begin() {
  Datum pattern = list("hold"_sym, Datum::symbol(context_.name), "?client"_sym, "?count"_sym);
  following_ = context_.executor.spawn(
      runtime::follow(context_, std::move(pattern), [this](Change change) { return take(std::move(change)); }));
}

Task<void> Holds::take(Change change) {
  see(change);
  co_return;
}

void Holds::see(const Change& change) {
  const std::map<std::string, Hold> before = holds_;
  if (change.resynchronised) {
    // One that is told of again has not been renewed by that.
    for (const Answer& answer : change.added) add(answer.facts.front());
    std::erase_if(holds_, [&](const auto& entry) {
      return std::ranges::none_of(change.added,
                                  [&](const Answer& answer) { return answer.facts.front().id == entry.second.fact; });
    });
  } else {
    for (const Answer& answer : change.added) add(answer.facts.front());
    for (const Answer& answer : change.removed) remove(answer.facts.front());
  }
  for (const auto& [client, hold] : before) {
    if (!holds_.contains(client)) gone(client);
  }
  heard_.wake_all();
}

// A hold counts only if its holder told it.
void Holds::add(const Fact& fact) {
  if (!fact.datum[2].is_symbol(fact.teller)) return;
  const auto known = holds_.find(fact.teller);
  const bool anew = known == holds_.end() || known->second.count != fact.datum[3];
  const Time renewed = anew ? context_.executor.now() : known->second.renewed;
  holds_.insert_or_assign(fact.teller, Hold{fact.id, fact.datum[3], renewed});
}

void Holds::remove(const Fact& fact) {
  std::erase_if(holds_, [&](const auto& entry) { return entry.second.fact == fact.id; });
}

void Holds::gone(const std::string& client) {
  if (client_.empty() || client != client_) return;
  control_.stop_at_once({std::string(released), fmt::format("{} has let go", client), Datum::symbol(client), {}});
}

bool Holds::is_fresh(const std::string& client, Duration deadline) const {
  const auto hold = holds_.find(client);
  return hold != holds_.end() && context_.executor.now() - hold->second.renewed < deadline;
}

Task<Result<void>> Holds::await(std::string client, Duration deadline) {
  const Time longest = context_.executor.now() + deadline;
  while (!is_fresh(client, deadline)) {
    const bool woken = co_await heard_.wait(longest);
    if (woken) continue;
    co_return fail("not-held",
                   fmt::format("{} does not hold on: there is no new (hold {} {} ...)", client, context_.name, client));
  }
  co_return Result<void>();
}

Holds::Watching::Watching(Holds& holds, std::string client, Duration deadline) : holds_(holds) {
  holds_.client_ = std::move(client);
  listening_ = holds_.context_.executor.spawn(holds_.listen(deadline));
}

Task<void> Holds::listen(Duration deadline) {
  while (true) {
    const auto hold = holds_.find(client_);
    if (hold == holds_.end()) {
      gone(client_);
      co_return;
    }
    const Time silent_at = hold->second.renewed + deadline;
    co_await sleep(context_.executor, silent_at - context_.executor.now());
    if (is_fresh(client_, deadline)) continue;
    co_await sleep(context_.executor, second_look);
    if (!holds_.contains(client_)) continue;
    if (!is_fresh(client_, deadline)) break;
  }
  control_.stop_at_once({"stopped",
                         fmt::format("{} has not renewed its hold for {} ms", client_, deadline.count() / 1000),
                         Datum::symbol(client_),
                         {}});
}

}  // namespace pizarra::robot
