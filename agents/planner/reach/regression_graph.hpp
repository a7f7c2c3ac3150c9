#pragma once

// The planning graph read backwards: which facts, pairs of facts and actions there can be k parallel steps before the
// goals are reached. Actions and facts missing from a layer are in no plan of that length.
//
//   RegressionGraph graph(problem, exclusions, interferes);
//   while (!graph.levelled_off()) graph.expand();
//   graph.fact_level(3).present.test(fact)          // may hold with three steps to go
//   graph.actions(3).test(action)                   // may be the third last
//
// To stand still is a step too, so levels only grow.

#include "agents/planner/reach/exclusions.hpp"
#include "agents/planner/reach/planning_graph.hpp"

namespace pizarra::planner {

class RegressionGraph {
 public:
  // The arguments outlive it; `interferes` is interference(problem).
  RegressionGraph(const Problem& problem, const Exclusions& exclusions, const std::vector<Bits>& interferes);

  void expand();
  bool levelled_off() const { return levelled_off_; }
  std::size_t size() const { return fact_levels_.size(); }
  // Beyond the last level stored: the last. In a row of `mutex` stand permanent exclusions too.
  const FactLevel& fact_level(std::size_t steps_to_go) const;
  const Bits& actions(std::size_t steps_to_go) const;  // at least 1
  // Whether the goals may be reached from the state in so many steps.
  bool allows(const Bits& state, std::size_t steps_to_go) const;

 private:
  // One action undone: of what must hold after it, what it lets hold before it.
  struct Undone {
    Bits after;     // holds afterwards for certain
    Bits taken;     // deleted, so may have held before
    Bits needed;    // its preconditions
    Bits unneeded;  // excluded by a precondition
  };
  bool together(std::size_t a, std::size_t b) const;
  void decide(FactLevel& before, std::size_t fact, std::size_t other) const;

  const Problem& problem_;
  const Exclusions& exclusions_;
  const std::vector<Bits>& interferes_;
  std::vector<Undone> undone_;
  std::vector<FactLevel> fact_levels_;
  std::vector<Bits> action_levels_;
  // Of the level that is being made: what every action's certain facts exclude after it, and who may have taken a fact.
  std::vector<Bits> excluded_after_;
  std::vector<std::vector<std::size_t>> takers_;
  bool levelled_off_ = false;
};

}  // namespace pizarra::planner
