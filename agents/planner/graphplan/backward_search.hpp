#pragma once

// The search of Graphplan: from the goals at a level of the planning graph, backwards, one level at a time, for actions
// that support them. A failure is explained by the goals that caused it; the explanation is remembered as a nogood and
// tells how far to jump back (Kambhampati, "Planning graph as a (dynamic) CSP", 2000).
//
//   BackwardSearch search(problem, graph, budget, cancelled);
//   const bool found = search.reach(problem.goals, 5);      // in five steps
//   search.steps();
//
// That no plan of any length exists is proved as in property directed reachability (Suda, "Property directed
// reachability for automated planning", 2014). The graph must have levelled off. A set of nogoods holds for ever if
// each of them, looked at one step back, leads to nothing but others of the set.

#include <functional>
#include <optional>
#include <string>

#include "agents/planner/graphplan/nogoods.hpp"
#include "agents/planner/reach/planning_graph.hpp"

namespace pizarra::planner {

class BackwardSearch {
 public:
  BackwardSearch(const Problem& problem, const PlanningGraph& graph, const Budget& budget,
                 const std::function<bool()>& cancelled);

  // Whether a plan of `level` steps reaches the goals. Meaningless once stopped() says so.
  bool reach(const Bits& goals, std::size_t level);
  // After reach() has failed up to `level` on a graph that has levelled off: those of the goals that exclude each other
  // for ever, or nothing when that is not proved yet.
  std::optional<std::vector<std::size_t>> excluded_for_ever(const Bits& goals, std::size_t level);

  // Of the last successful reach(): the actions, without those that only keep a fact.
  const std::vector<std::vector<std::size_t>>& steps() const { return steps_; }
  std::size_t nodes() const { return nodes_; }
  bool stopped() const { return cancelled_seen_ || !spent_.empty(); }
  bool cancelled() const { return cancelled_seen_; }
  // The bound that was reached first; empty: none.
  const std::string& spent() const { return spent_; }

 private:
  struct Choice {
    std::size_t action;
    std::size_t goal;  // what the action was chosen for
  };
  // Looked into, instead of searching on: nogoods and the level they must be proved for.
  struct Horizon {
    const Nogoods& nogoods;
    std::size_t level;
  };
  // The goals of one level, and what is chosen for them so far.
  struct Level {
    std::size_t index;
    const Bits& goals;
    const ActionLevel& actions;
    const Horizon* horizon;  // null: none
    std::vector<Choice> choices = {};
  };

  bool solve(const Bits& goals, std::size_t level, Bits& conflict);
  bool support(const Bits& goals, std::size_t level, const Horizon* horizon, Bits& conflict);
  void shrink(Bits& conflict, std::size_t level);
  bool choose(Level& level, const Bits& open, const Bits& excluded, Bits& conflict);
  bool descend(Level& level, Bits& conflict);
  std::size_t hardest(const Level& level, const Bits& open, const Bits& excluded) const;
  void blame_exclusions(const Level& level, std::size_t goal, const Bits& excluded, Bits& conflict) const;
  bool push_all(std::size_t level);
  Nogoods inductive(std::size_t level);
  Bits bits_of(const Nogoods::Entry& nogood) const;
  void count_node();

  const Problem& problem_;
  const PlanningGraph& graph_;
  const Budget& budget_;
  const std::function<bool()>& is_cancelled_;
  Nogoods nogoods_;
  std::vector<std::vector<std::size_t>> steps_;
  std::size_t nodes_ = 0;
  std::size_t depth_ = 0;
  bool cancelled_seen_ = false;
  std::string spent_;
};

}  // namespace pizarra::planner
