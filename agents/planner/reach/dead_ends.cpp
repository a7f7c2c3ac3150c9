#include "agents/planner/reach/dead_ends.hpp"

#include <algorithm>

namespace pizarra::planner {

namespace {

// What holds after the action for certain.
std::vector<std::size_t> certain_after(const GroundAction& action) {
  std::vector<std::size_t> kept, facts;
  std::ranges::set_difference(action.preconditions, action.deletes, std::back_inserter(kept));
  std::ranges::set_union(kept, action.adds, std::back_inserter(facts));
  return facts;
}

}  // namespace

DeadEnds::DeadEnds(const Problem& problem, const Exclusions& exclusions, const std::function<bool()>& cancelled)
    : hopeful_(problem.facts.size(), Bits(problem.facts.size())) {
  Bits beside_goals = exclusions.facts();
  problem.goals.for_each([&](std::size_t goal) { beside_goals -= exclusions.with(goal); });
  beside_goals.for_each([&](std::size_t fact) {
    hopeful_[fact] = beside_goals;
    hopeful_[fact] -= exclusions.with(fact);
  });
  if (!exclusions.allow(problem.goals)) hopeful_.assign(problem.facts.size(), Bits(problem.facts.size()));
  while (!cancelled() && grow(problem, exclusions, cancelled)) {
  }
}

bool DeadEnds::grow(const Problem& problem, const Exclusions& exclusions, const std::function<bool()>& cancelled) {
  bool grown = false;
  exclusions.actions().for_each([&](std::size_t i) {
    if (cancelled()) return;
    const GroundAction& action = problem.actions[i];
    const std::vector<std::size_t> after = certain_after(action);
    Bits kept = exclusions.facts();
    for (const std::size_t fact : after) kept &= hopeful_[fact];
    if (!std::ranges::all_of(after, [&](std::size_t fact) { return kept.test(fact); })) return;
    // Before the action: what it needs, what it takes away, and what may stay beside it.
    Bits before = kept;
    Bits changed(problem.facts.size());
    for (const std::size_t fact : action.preconditions) changed.set(fact);
    for (const std::size_t fact : action.deletes) changed.set(fact);
    before |= changed;
    for (const std::size_t fact : action.preconditions) {
      before -= exclusions.with(fact);
      changed -= exclusions.with(fact);
    }
    changed &= exclusions.facts();
    changed.for_each([&](std::size_t fact) {
      Bits others = before;
      others -= exclusions.with(fact);
      grown |= join(fact, others);
    });
  });
  return grown;
}

bool DeadEnds::join(std::size_t fact, const Bits& others) {
  Bits fresh = others;
  fresh -= hopeful_[fact];
  if (!fresh.any()) return false;
  hopeful_[fact] |= fresh;
  fresh.for_each([&](std::size_t other) { hopeful_[other].set(fact); });
  return true;
}

bool DeadEnds::contain(const Bits& state) const {
  bool hopeful = true;
  state.for_each([&](std::size_t fact) { hopeful = hopeful && state.subset_of(hopeful_[fact]); });
  return !hopeful;
}

}  // namespace pizarra::planner
