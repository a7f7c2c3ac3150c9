#include "agents/console/kept_changes.hpp"

#include <algorithm>
#include <set>

#include "agents/console/journalled_changes.hpp"
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

// The newest of those that are not kept yet.
void put_before(std::deque<KeptChange>& kept, const std::deque<KeptChange>& earlier) {
  std::set<FactId> known;
  for (const KeptChange& change : kept) known.insert(change.fact.id);
  for (auto change = earlier.rbegin(); change != earlier.rend() && kept.size() < KeptChanges::most; ++change) {
    if (!known.contains(change->fact.id)) kept.push_front(*change);
  }
}

}  // namespace

void KeptChanges::Kept::take_servo(const std::vector<Fact>& told) {
  for (const Fact& fact : told) {
    if (!servo.empty() && !servo_ended) servo.back().until = fact.when;
    if (servo_ended || !goes_on(servo.back().fact, fact)) keep(servo, fact);
    servo_ended = false;
  }
  servo_ended = told.empty();
}

void KeptChanges::Kept::take_sighting(const Fact& fact) { keep(sightings, fact); }

KeptChanges::KeptChanges(Executor& executor, std::unique_ptr<Board> board, std::string journal)
    : executor_(executor),
      board_(std::move(board)),
      read_(executor),
      following_servo_(executor.spawn(follow_servo())),
      following_sightings_(executor.spawn(follow_sightings())),
      reading_(executor.spawn(read_journal(std::move(journal)))) {}

Datum KeptChanges::servo_pattern() { return list("servo"_sym, "?s"_sym, "?o"_sym, "?x"_sym, "?y"_sym, "?d"_sym); }
Datum KeptChanges::sighting_pattern() { return list("tracked"_sym, "?e"_sym, "?n"_sym, "?s"_sym, "?f"_sym, "?c"_sym); }

Task<void> KeptChanges::read() { co_await read_.wait(); }

// A journal that cannot be read is as none: who asks the board about the past is told why.
Task<void> KeptChanges::read_journal(std::string journal) {
  const auto earlier = std::make_shared<Kept>();
  const std::function<void(const std::function<bool()>&)> work = [earlier,
                                                                  journal](const std::function<bool()>& is_cancelled) {
    *earlier = journalled_changes(journal, is_cancelled);
  };
  if (!journal.empty()) co_await executor_.offload(work, Duration::zero());
  put_before(kept_.servo, earlier->servo);
  put_before(kept_.sightings, earlier->sightings);
  read_.set();
}

Task<void> KeptChanges::follow_servo() {
  const Result<std::unique_ptr<Watch>> watch =
      co_await runtime::watch_when_declared(*board_, query_for(servo_pattern()));
  if (!watch) co_return;
  while (true) {
    const Result<Change> change = co_await (*watch)->next();
    if (!change) co_return;
    std::vector<Fact> told;
    for (const Answer& answer : change->added) told.push_back(answer.facts.front());
    kept_.take_servo(told);
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
      if (!change->resynchronised || !is_kept(kept_.sightings, fact)) kept_.take_sighting(fact);
    }
  }
}

}  // namespace pizarra::console
