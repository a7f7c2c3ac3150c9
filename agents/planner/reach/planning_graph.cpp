#include "agents/planner/reach/planning_graph.hpp"

#include <algorithm>

namespace pizarra::planner {

PlanningGraph::PlanningGraph(const Problem& problem) : problem_(problem) {
  const std::size_t fact_count = problem.facts.size();
  const std::size_t count = problem.actions.size() + fact_count;
  supporters_.assign(fact_count, Bits(count));
  deleters_.assign(fact_count, Bits(count));
  needers_.assign(fact_count, Bits(count));
  precondition_bits_.assign(count, Bits(fact_count));
  add_bits_.assign(count, Bits(fact_count));
  interferes_.assign(count, Bits(count));
  for (const GroundAction& action : problem.actions) preconditions_.push_back(action.preconditions);
  for (std::size_t fact = 0; fact < fact_count; ++fact) preconditions_.push_back({fact});

  for (std::size_t action = 0; action < count; ++action) {
    for (const std::size_t fact : preconditions_[action]) {
      precondition_bits_[action].set(fact);
      needers_[fact].set(action);
    }
    const std::vector<std::size_t>& adds = keeps(action) ? preconditions_[action] : problem.actions[action].adds;
    for (const std::size_t fact : adds) {
      add_bits_[action].set(fact);
      supporters_[fact].set(action);
    }
  }
  for (std::size_t action = 0; action < problem.actions.size(); ++action) {
    for (const std::size_t fact : problem.actions[action].deletes) {
      deleters_[fact].set(action);
      interferes_[action] |= needers_[fact];
      interferes_[action] |= supporters_[fact];
    }
  }
  for (std::size_t action = 0; action < problem.actions.size(); ++action) {
    interferes_[action].reset(action);
    interferes_[action].for_each([&](std::size_t other) { interferes_[other].set(action); });
  }

  FactLevel first{.present = problem.initials, .mutex = std::vector<Bits>(fact_count, Bits(fact_count))};
  fact_levels_.push_back(std::move(first));
}

void PlanningGraph::expand() {
  if (levelled_off_) return;
  ActionLevel actions = next_actions(fact_levels_.back());
  FactLevel facts = next_facts(fact_levels_.back(), actions);
  // The action level beyond a levelled-off pair of fact levels is kept, because it is that of all later levels.
  if (facts == fact_levels_.back()) levelled_off_ = fact_levels_.size() - 1;
  action_levels_.push_back(std::move(actions));
  fact_levels_.push_back(std::move(facts));
}

const FactLevel& PlanningGraph::fact_level(std::size_t level) const {
  return fact_levels_[std::min(level, fact_levels_.size() - 1)];
}

const ActionLevel& PlanningGraph::action_level(std::size_t level) const {
  return action_levels_[std::min(level, action_levels_.size()) - 1];
}

// An action can be taken when its preconditions hold and none excludes another. Two exclude each other when they
// interfere or when a precondition of one excludes one of the other.
ActionLevel PlanningGraph::next_actions(const FactLevel& facts) const {
  const std::size_t count = action_count();
  ActionLevel level{.present = Bits(count), .mutex = std::vector<Bits>(count, Bits(count))};
  for (std::size_t action = 0; action < count; ++action) {
    if (!precondition_bits_[action].subset_of(facts.present)) continue;
    Bits excluded_facts(problem_.facts.size());
    for (const std::size_t fact : preconditions_[action]) excluded_facts |= facts.mutex[fact];
    if (excluded_facts.intersects(precondition_bits_[action])) continue;
    level.present.set(action);
    level.mutex[action] = interferes_[action];
    excluded_facts.for_each([&](std::size_t fact) { level.mutex[action] |= needers_[fact]; });
  }
  level.present.for_each([&](std::size_t action) { level.mutex[action] &= level.present; });
  return level;
}

// Two facts exclude each other when every way to get one excludes every way to get the other.
FactLevel PlanningGraph::next_facts(const FactLevel& before, const ActionLevel& actions) const {
  const std::size_t fact_count = problem_.facts.size();
  FactLevel level{.present = Bits(fact_count), .mutex = std::vector<Bits>(fact_count, Bits(fact_count))};
  actions.present.for_each([&](std::size_t action) { level.present |= add_bits_[action]; });
  std::vector<Bits> usable = supporters_;
  for (Bits& row : usable) row &= actions.present;

  level.present.for_each([&](std::size_t fact) {
    Bits excluded = actions.present;
    usable[fact].for_each([&](std::size_t action) { excluded &= actions.mutex[action]; });
    level.present.for_each([&](std::size_t other) {
      if (other >= fact) return;
      const bool undecided =
          !before.present.test(fact) || !before.present.test(other) || before.mutex[fact].test(other);
      if (undecided && usable[other].subset_of(excluded)) {
        level.mutex[fact].set(other);
        level.mutex[other].set(fact);
      }
    });
  });
  return level;
}

std::size_t PlanningGraph::base_bytes(const Problem& problem) {
  const std::size_t facts = problem.facts.size();
  const std::size_t actions = problem.actions.size() + facts;
  return (actions * actions + 3 * facts * actions + 2 * actions * facts) / 8 + 100 * (actions + facts);
}

std::size_t PlanningGraph::bytes_per_level() const {
  const std::size_t facts = problem_.facts.size();
  const std::size_t actions = action_count();
  return (actions * actions + facts * facts) / 8 + 32 * (actions + facts);
}

std::size_t PlanningGraph::bytes() const { return base_bytes(problem_) + size() * bytes_per_level(); }

}  // namespace pizarra::planner
