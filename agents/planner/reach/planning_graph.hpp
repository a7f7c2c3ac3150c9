#pragma once

// The planning graph of Graphplan (Blum & Furst, "Fast planning through planning graph analysis", 1997): which facts
// and which pairs of facts can possibly hold after k parallel steps, and which actions and pairs of them can be taken.
//
//   PlanningGraph graph(problem);
//   while (!graph.levelled_off()) graph.expand();
//   graph.fact_level(3).mutex[p].test(q);     // p and q exclude each other after three steps
//
// Actions are numbered as in the problem, and behind them stands, for every fact, the action that keeps it. Facts and
// actions only ever appear and exclusions only ever vanish, so the graph stops changing: it has levelled off, and every
// later level is the last one again.

#include <optional>
#include <vector>

#include "agents/planner/task/problem.hpp"

namespace pizarra::planner {

struct FactLevel {
  Bits present;
  std::vector<Bits> mutex;  // a row for every fact; empty for one that is not present
  bool operator==(const FactLevel&) const = default;
};

struct ActionLevel {
  Bits present;
  std::vector<Bits> mutex;  // a row for every action, of present actions only
};

class PlanningGraph {
 public:
  explicit PlanningGraph(const Problem& problem);

  // Adds one level; nothing once levelled off.
  void expand();
  // The index of the first fact level that equals its successor.
  std::optional<std::size_t> levelled_off() const { return levelled_off_; }
  // How many levels of facts there are; level 0 holds the initial facts.
  std::size_t size() const { return fact_levels_.size(); }
  // Levels beyond the last stored one are the last one.
  const FactLevel& fact_level(std::size_t level) const;
  // The actions that lead from fact level `level - 1` to `level`; level at least 1.
  const ActionLevel& action_level(std::size_t level) const;

  std::size_t action_count() const { return preconditions_.size(); }
  bool keeps(std::size_t action) const { return action >= problem_.actions.size(); }
  const std::vector<std::size_t>& preconditions(std::size_t action) const { return preconditions_[action]; }
  const Bits& adds(std::size_t action) const { return add_bits_[action]; }
  // The actions that add, or delete, a fact.
  const Bits& supporters(std::size_t fact) const { return supporters_[fact]; }
  const Bits& deleters(std::size_t fact) const { return deleters_[fact]; }

  // Memory in use, and what an estimate says one more level would take.
  std::size_t bytes() const;
  std::size_t bytes_per_level() const;
  // The memory of a planning graph before its first level.
  static std::size_t base_bytes(const Problem& problem);

 private:
  ActionLevel next_actions(const FactLevel& facts) const;
  FactLevel next_facts(const FactLevel& before, const ActionLevel& actions) const;

  const Problem& problem_;
  std::vector<std::vector<std::size_t>> preconditions_;
  std::vector<Bits> precondition_bits_, add_bits_;     // of every action, over facts
  std::vector<Bits> supporters_, deleters_, needers_;  // of every fact, over actions
  std::vector<Bits> interferes_;                       // of every action, over actions
  std::vector<FactLevel> fact_levels_;
  std::vector<ActionLevel> action_levels_;
  std::optional<std::size_t> levelled_off_;
};

}  // namespace pizarra::planner
