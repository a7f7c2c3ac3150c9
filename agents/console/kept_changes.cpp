#include "agents/console/kept_changes.hpp"

#include <algorithm>

#include "agents/runtime/declared.hpp"

namespace pizarra::console {

namespace {

void keep(std::deque<KeptChange>& kept, const Fact& fact) {
  kept.push_back({fact, fact.when});
  if (kept.size() > KeptChanges::most) kept.pop_front();
}

// A board that is heard again tells anew what stands.
bool is_kept(const std::deque<KeptChange>& kept, const Fact& fact) {
  return std::ranges::any_of(kept, [&fact](const KeptChange& change) { return change.fact.id == fact.id; });
}

// The servo tells its errors many times in a state.
bool goes_on(const Fact& before, const Fact& fact) {
  return before.datum[1] == fact.datum[1] && before.datum[2] == fact.datum[2];
}

}  // namespace

KeptChanges::KeptChanges(Executor& executor, std::unique_ptr<Board> board)
    : board_(std::move(board)),
      following_servo_(executor.spawn(follow_servo())),
      following_sightings_(executor.spawn(follow_sightings())) {}

Datum KeptChanges::servo_pattern() { return list("servo"_sym, "?s"_sym, "?o"_sym, "?x"_sym, "?y"_sym, "?d"_sym); }
Datum KeptChanges::sighting_pattern() { return list("tracked"_sym, "?e"_sym, "?n"_sym, "?s"_sym, "?f"_sym, "?c"_sym); }

Task<void> KeptChanges::follow_servo() {
  const Result<std::unique_ptr<Watch>> watch =
      co_await runtime::watch_when_declared(*board_, query_for(servo_pattern()));
  if (!watch) co_return;
  bool ended = true;
  while (true) {
    const Result<Change> change = co_await (*watch)->next();
    if (!change) co_return;
    for (const Answer& answer : change->added) {
      const Fact& fact = answer.facts.front();
      if (!servo_.empty() && !ended) servo_.back().until = fact.when;
      if (ended || !goes_on(servo_.back().fact, fact)) keep(servo_, fact);
    }
    ended = change->added.empty();
  }
}

Task<void> KeptChanges::follow_sightings() {
  const Result<std::unique_ptr<Watch>> watch =
      co_await runtime::watch_when_declared(*board_, query_for(sighting_pattern()));
  if (!watch) co_return;
  while (true) {
    const Result<Change> change = co_await (*watch)->next();
    if (!change) co_return;
    for (const Answer& answer : change->added) {
      const Fact& fact = answer.facts.front();
      if (!change->resynchronised || !is_kept(sightings_, fact)) keep(sightings_, fact);
    }
  }
}

}  // namespace pizarra::console
