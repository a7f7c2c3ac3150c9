#pragma once

// How many steps are needed at least, where one resource is all that matters: a group of facts that exclude each other,
// like what a hand holds, and the actions that take one of them away. At most one such action fits into a step.
//
//   LandmarkBound bound(problem, exclusions, group);
//   if (bound.counts_every_action()) bound.from(state);       // at least so many steps from the state to the goals
//
// Facts of the group that must come to hold, and go again, are visits; each takes two of the actions. What must happen
// before what orders the first visit of a fact before the first visit of another, and last visits before last visits.
// A fact that is visited just once has one visit that is first and last, so a cycle says that one of the facts on it is
// visited again (Büchner, Keller & Helmert, "Exploiting cyclic dependencies in landmark heuristics", 2021); the fewest
// repeated visits break every cycle. In blocks world: every block that must be moved, and the blocks to be put aside.

#include <optional>

#include "agents/planner/optimal/exclusions.hpp"
#include "agents/planner/optimal/relaxed_reach.hpp"
#include "agents/planner/optimal/visit_order.hpp"

namespace pizarra {

class LandmarkBound {
 public:
  // The arguments outlive it.
  LandmarkBound(const Problem& problem, const Exclusions& exclusions, const FactGroup& group)
      : LandmarkBound(problem, exclusions, group, [] { return false; }) {}
  // Worthless once cancelled() was true.
  LandmarkBound(const Problem& problem, const Exclusions& exclusions, const FactGroup& group,
                const std::function<bool()>& cancelled);

  // Whether each action that can be taken is counted, so that no two of them fit into one step.
  bool counts_every_action() const { return counts_every_action_; }
  // How many facts of the group may need visits; without any the bound is 0.
  std::size_t visitable() const { return visits_.size(); }
  // None: the goals are out of reach. The state respects the exclusions.
  std::optional<std::size_t> from(const Bits& state);

 private:
  struct Visit {
    std::size_t fact;
    bool must_end;  // the fact excludes a goal
    Bits enter, leave, both;
    Bits leave_last;  // with which a last visit can end
    Bits ends_after;  // visits whose last must be over before the last of this one ends
  };
  void add_visit(std::size_t fact);
  void find_last_leaves(Visit& visit, const std::function<bool()>& cancelled);
  Bits possible_after(const GroundAction& action) const;
  bool required(const Visit& visit, const Bits& state) const;
  VisitOrder order_of(const std::vector<std::size_t>& wanted, const std::vector<Bits>& without,
                      std::optional<std::size_t> current) const;
  int fewest_extra(const std::vector<std::size_t>& wanted, const VisitOrder& order) const;

  const Problem& problem_;
  const Exclusions& exclusions_;
  RelaxedReach reach_;
  Bits no_action_;
  Bits counted_;
  bool counts_every_action_ = false;
  Bits excluded_by_goals_;
  std::vector<Bits> deleters_;
  std::vector<Visit> visits_;
};

}  // namespace pizarra
