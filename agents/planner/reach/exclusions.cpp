#include "agents/planner/reach/exclusions.hpp"

#include <algorithm>

namespace pizarra::planner {

namespace {

// Grows the pairs of facts that can hold together until the actions add none.
class PairGrowth {
 public:
  PairGrowth(const Problem& problem, const std::function<bool()>& cancelled)
      : problem_(problem),
        cancelled_(cancelled),
        together_(problem.facts.size(), Bits(problem.facts.size())),
        taken_(problem.actions.size()) {
    problem.initials.for_each([&](std::size_t fact) { together_[fact] = problem.initials; });
    while (!cancelled_() && grow()) {
    }
  }

  std::vector<Bits>& together() { return together_; }
  const Bits& taken() const { return taken_; }

 private:
  bool grow() {
    bool grown = false;
    for (std::size_t i = 0; i < problem_.actions.size(); ++i) {
      const GroundAction& action = problem_.actions[i];
      if (!applicable(action)) continue;
      if (cancelled_()) return false;
      taken_.set(i);
      Bits after = beside(action);
      for (const std::size_t fact : action.deletes) after.reset(fact);
      for (const std::size_t fact : action.adds) after.set(fact);
      for (const std::size_t fact : action.adds) grown |= join(fact, after);
    }
    return grown;
  }

  bool applicable(const GroundAction& action) const {
    for (const std::size_t fact : action.preconditions) {
      for (const std::size_t other : action.preconditions) {
        if (!together_[fact].test(other)) return false;
      }
    }
    return true;
  }

  // What can hold when the action is taken.
  Bits beside(const GroundAction& action) const {
    if (!action.preconditions.empty()) {
      Bits facts = together_[action.preconditions.front()];
      for (const std::size_t fact : action.preconditions) facts &= together_[fact];
      return facts;
    }
    Bits facts(problem_.facts.size());
    for (std::size_t fact = 0; fact < problem_.facts.size(); ++fact) {
      if (together_[fact].test(fact)) facts.set(fact);
    }
    return facts;
  }

  bool join(std::size_t fact, const Bits& others) {
    Bits fresh = others;
    fresh -= together_[fact];
    if (!fresh.any()) return false;
    together_[fact] |= fresh;
    fresh.for_each([&](std::size_t other) { together_[other].set(fact); });
    return true;
  }

  const Problem& problem_;
  const std::function<bool()>& cancelled_;
  std::vector<Bits> together_;  // a fact together with itself: it can hold
  Bits taken_;
};

// The clique that grows from `seed`, first by a fact that no clique joins to it yet, always by the one that leaves most
// candidates.
FactGroup clique_from(std::size_t seed, const Exclusions& exclusions, const std::vector<Bits>& uncovered) {
  FactGroup clique{seed};
  Bits candidates = exclusions.with(seed);
  while (candidates.any()) {
    std::size_t best = 0;
    std::size_t best_score = 0;
    const Bits& choices = clique.size() == 1 ? uncovered[seed] : candidates;
    choices.for_each([&](std::size_t fact) {
      Bits left = exclusions.with(fact);
      left &= candidates;
      const auto news = std::ranges::count_if(clique, [&](std::size_t in) { return uncovered[in].test(fact); });
      const std::size_t score = 1 + 2 * left.count() + static_cast<std::size_t>(news);
      if (score <= best_score) return;
      best_score = score;
      best = fact;
    });
    clique.push_back(best);
    candidates &= exclusions.with(best);
  }
  std::ranges::sort(clique);
  return clique;
}

}  // namespace

Exclusions::Exclusions(const Problem& problem, const std::function<bool()>& cancelled)
    : facts_(problem.facts.size()), actions_(problem.actions.size()) {
  PairGrowth growth(problem, cancelled);
  actions_ = growth.taken();
  for (std::size_t fact = 0; fact < problem.facts.size(); ++fact) {
    if (growth.together()[fact].test(fact)) facts_.set(fact);
  }
  // In place: the table is the largest there is.
  excluded_ = std::move(growth.together());
  for (std::size_t fact = 0; fact < problem.facts.size(); ++fact) {
    Bits excluded = facts_;
    excluded -= excluded_[fact];
    if (!facts_.test(fact)) excluded.clear();
    excluded_[fact] = std::move(excluded);
  }
}

Exclusions::Exclusions(const Problem& problem, const std::vector<FactGroup>& groups)
    : facts_(problem.facts.size()),
      actions_(problem.actions.size()),
      excluded_(problem.facts.size(), Bits(problem.facts.size())) {
  for (std::size_t fact = 0; fact < problem.facts.size(); ++fact) facts_.set(fact);
  for (std::size_t action = 0; action < problem.actions.size(); ++action) actions_.set(action);
  for (const FactGroup& group : groups) {
    Bits members(problem.facts.size());
    for (const std::size_t fact : group) members.set(fact);
    for (const std::size_t fact : group) excluded_[fact] |= members;
  }
  for (std::size_t fact = 0; fact < problem.facts.size(); ++fact) excluded_[fact].reset(fact);
}

bool Exclusions::allow(const Bits& facts) const {
  if (!facts.subset_of(facts_)) return false;
  bool allowed = true;
  facts.for_each([&](std::size_t fact) { allowed = allowed && !excluded_[fact].intersects(facts); });
  return allowed;
}

std::vector<FactGroup> exclusion_groups(const Exclusions& exclusions, const std::function<bool()>& cancelled) {
  std::vector<Bits> uncovered;
  std::vector<std::size_t> open;
  const std::size_t count = exclusions.facts().words().size() * 64;
  for (std::size_t fact = 0; fact < count; ++fact) {
    const bool known = exclusions.facts().test(fact);
    uncovered.push_back(known ? exclusions.with(fact) : Bits(count));
    open.push_back(uncovered.back().count());
  }
  std::vector<FactGroup> groups;
  while (!cancelled()) {
    const auto seed = static_cast<std::size_t>(std::ranges::max_element(open) - open.begin());
    if (open.empty() || open[seed] == 0) break;
    FactGroup group = clique_from(seed, exclusions, uncovered);
    for (const std::size_t fact : group) {
      for (const std::size_t other : group) {
        if (fact == other || !uncovered[fact].test(other)) continue;
        uncovered[fact].reset(other);
        --open[fact];
      }
    }
    groups.push_back(std::move(group));
  }
  return groups;
}

}  // namespace pizarra::planner
