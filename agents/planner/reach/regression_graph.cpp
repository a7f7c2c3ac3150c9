#include "agents/planner/reach/regression_graph.hpp"

#include <algorithm>

namespace pizarra::planner {

RegressionGraph::RegressionGraph(const Problem& problem, const Exclusions& exclusions,
                                 const std::vector<Bits>& interferes)
    : problem_(problem), exclusions_(exclusions), interferes_(interferes) {
  const std::size_t facts = problem.facts.size();
  for (const GroundAction& action : problem.actions) {
    Undone undone{Bits(facts), Bits(facts), Bits(facts), Bits(facts)};
    for (const std::size_t fact : action.preconditions) {
      undone.needed.set(fact);
      undone.unneeded |= exclusions.with(fact);
    }
    for (const std::size_t fact : action.deletes) undone.taken.set(fact);
    undone.after = undone.needed;
    undone.after -= undone.taken;
    for (const std::size_t fact : action.adds) undone.after.set(fact);
    undone_.push_back(std::move(undone));
  }
  FactLevel goals{.present = exclusions.facts(), .mutex = std::vector<Bits>(facts, Bits(facts))};
  problem.goals.for_each([&](std::size_t goal) { goals.present -= exclusions.with(goal); });
  goals.present.for_each([&](std::size_t fact) { goals.mutex[fact] = exclusions.with(fact); });
  fact_levels_.push_back(std::move(goals));
}

const FactLevel& RegressionGraph::fact_level(std::size_t steps_to_go) const {
  return fact_levels_[std::min(steps_to_go, fact_levels_.size() - 1)];
}

const Bits& RegressionGraph::actions(std::size_t steps_to_go) const {
  return action_levels_[std::min(steps_to_go, action_levels_.size()) - 1];
}

bool RegressionGraph::allows(const Bits& state, std::size_t steps_to_go) const {
  const FactLevel& level = fact_level(steps_to_go);
  bool allowed = state.subset_of(level.present);
  state.for_each([&](std::size_t fact) { allowed = allowed && !level.mutex[fact].intersects(state); });
  return allowed;
}

// Whether two actions of the level being made can be undone at once.
bool RegressionGraph::together(std::size_t a, std::size_t b) const {
  return a == b || (!interferes_[a].test(b) && !excluded_after_[a].intersects(undone_[b].after) &&
                    !undone_[a].unneeded.intersects(undone_[b].needed));
}

// Excludes the two facts unless each has a way to hold beside the other's.
void RegressionGraph::decide(FactLevel& before, std::size_t fact, std::size_t other) const {
  const FactLevel& after = fact_levels_.back();
  const auto keeps = [&](std::size_t action, std::size_t kept) {
    return after.present.test(kept) && !excluded_after_[action].test(kept) && !undone_[action].unneeded.test(kept) &&
           !undone_[action].taken.test(kept);
  };
  const auto taken_beside = [&](std::size_t taken, std::size_t kept) {
    return std::ranges::any_of(takers_[taken], [&](std::size_t action) { return keeps(action, kept); });
  };
  const auto both_taken = [&] {
    return std::ranges::any_of(takers_[fact], [&](std::size_t a) {
      if (undone_[a].unneeded.test(other)) return false;
      return std::ranges::any_of(takers_[other],
                                 [&](std::size_t b) { return !undone_[b].unneeded.test(fact) && together(a, b); });
    });
  };
  const bool allowed = !exclusions_.with(fact).test(other) &&
                       ((after.present.test(fact) && after.present.test(other) && !after.mutex[fact].test(other)) ||
                        taken_beside(fact, other) || taken_beside(other, fact) || both_taken());
  if (allowed) return;
  before.mutex[fact].set(other);
  before.mutex[other].set(fact);
}

void RegressionGraph::expand() {
  if (levelled_off_) return;
  const FactLevel& after = fact_levels_.back();
  const std::size_t facts = problem_.facts.size();
  Bits actions(problem_.actions.size());
  FactLevel before{.present = after.present, .mutex = std::vector<Bits>(facts, Bits(facts))};
  excluded_after_.assign(problem_.actions.size(), Bits(facts));
  takers_.assign(facts, {});
  exclusions_.actions().for_each([&](std::size_t action) {
    const Undone& undone = undone_[action];
    if (!undone.after.subset_of(after.present)) return;
    undone.after.for_each([&](std::size_t fact) { excluded_after_[action] |= after.mutex[fact]; });
    if (excluded_after_[action].intersects(undone.after)) return;
    actions.set(action);
    undone.taken.for_each([&](std::size_t fact) {
      takers_[fact].push_back(action);
      before.present.set(fact);
    });
  });
  before.present &= exclusions_.facts();
  before.present.for_each([&](std::size_t fact) {
    before.present.for_each([&](std::size_t other) {
      if (other < fact) decide(before, fact, other);
    });
  });
  levelled_off_ = before == after;
  action_levels_.push_back(std::move(actions));
  fact_levels_.push_back(std::move(before));
}

}  // namespace pizarra::planner
