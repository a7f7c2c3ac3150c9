#pragma once

// The facts that can never hold, and the facts that can never hold together, from the initial facts on: the pairs that
// h2 finds (Haslum & Geffner, "Admissible heuristics for optimal planning", 2000). The states that respect them are
// closed under the actions, so they stay true from any such state.
//
//   const Exclusions exclusions(problem);           // or with what says that it is wanted no more
//   exclusions.with(3).test(5);                     // 3 and 5 never hold together
//   for (const Facts& group : exclusion_groups(exclusions)) ...     // at most one fact of a group holds at a time

#include <vector>

#include "agents/planner/task/problem.hpp"

namespace pizarra::planner {

using FactGroup = std::vector<std::size_t>;

class Exclusions {
 public:
  explicit Exclusions(const Problem& problem) : Exclusions(problem, [] { return false; }) {}
  // Worthless once cancelled() was true.
  Exclusions(const Problem& problem, const std::function<bool()>& cancelled);
  // Only what is known already: of each group, at most one fact holds at a time. Nothing is ruled out by itself.
  Exclusions(const Problem& problem, const std::vector<FactGroup>& groups);

  // The facts that can hold at all, and the actions that can be taken.
  const Bits& facts() const { return facts_; }
  const Bits& actions() const { return actions_; }
  // The facts that never hold together with this one; empty for one that never holds.
  const Bits& with(std::size_t fact) const { return excluded_[fact]; }
  // Whether every fact can hold and no two exclude each other.
  bool allow(const Bits& facts) const;

 private:
  Bits facts_, actions_;
  std::vector<Bits> excluded_;
};

// Cliques of facts that exclude each other, ascending within, such that every excluded pair stands in one of them;
// found greedily, the larger ones first. Where it is cancelled, some pairs stand in none.
std::vector<FactGroup> exclusion_groups(
    const Exclusions& exclusions, const std::function<bool()>& cancelled = [] { return false; });

}  // namespace pizarra::planner
