#pragma once

// How many steps are needed at least, where one resource is all that matters: a group of facts that exclude each other,
// like what a hand holds, and the actions that take one of them away. At most one such action fits into a step.
//
//   LandmarkBound bound(problem, exclusions, group);
//   if (bound.counts_every_action()) bound.from(state);       // at least so many steps from the state to the goals
//
// Facts of the group that must come to hold, and go again, are visits; each takes two of the actions. The order of
// necessary events orders the first visit of a fact before the first visit of another, and last visits before last
// visits. A fact that is visited just once has one visit that is first and last. So a cycle says that one of the facts
// on it is visited again (Büchner, Keller & Helmert, "Exploiting cyclic dependencies in landmark heuristics", 2021);
// the fewest repeated visits break every cycle. In blocks world: every block that must be moved, and the blocks to be
// put aside.

#include <optional>

#include "agents/planner/guided/relaxed_landmarks.hpp"
#include "agents/planner/guided/visit_order.hpp"
#include "agents/planner/reach/exclusions.hpp"
#include "agents/planner/reach/relaxed_reach.hpp"

namespace pizarra::planner {

// The facts of a group of which every one of the actions takes one away, if there is such a group.
std::optional<FactGroup> resource_of_all(const Problem& problem, const Bits& actions,
                                         const std::vector<FactGroup>& groups);

class LandmarkBound {
 public:
  // The arguments outlive it.
  // Worthless once cancelled() was true.
  LandmarkBound(
      const Problem& problem, const Exclusions& exclusions, const FactGroup& group,
      const std::function<bool()>& cancelled = [] { return false; });

  // Whether each action that can be taken is counted, so that no two of them fit into one step.
  bool counts_every_action() const { return counts_every_action_; }
  // None: the goals are out of reach. The state respects the exclusions.
  std::optional<std::size_t> from(const Bits& state);

 private:
  using Actions = std::vector<std::uint32_t>;  // ascending
  struct Visit {
    std::size_t fact;
    bool must_end;  // the fact excludes a goal
    Actions enter, leave;
    Actions leave_last;  // with which a last visit can end
    Bits ends_after;     // visits whose last must be over before the last of this one ends
  };
  void add_visit(std::size_t fact);
  void keep_disjoint();
  void find_last_leaves(std::size_t index, RelaxedReach& reach, const std::function<bool()>& cancelled);
  bool goals_in_reach(const Bits& after, const Bits& forbidden, RelaxedReach& reach) const;
  Bits possible_after(const GroundAction& action) const;
  Bits required(const Bits& state) const;
  VisitOrder order_of(const std::vector<std::size_t>& wanted, std::optional<std::size_t> current) const;
  int fewest_extra(const std::vector<std::size_t>& wanted, const VisitOrder& order) const;

  const Problem& problem_;
  const Exclusions& exclusions_;
  Bits counted_;
  bool counts_every_action_ = false;
  Bits excluded_by_goals_;
  std::vector<Actions> adders_, deleters_;  // of every fact
  std::vector<Visit> visits_;
  std::vector<std::uint32_t> visit_of_;      // of every action: the visit that it begins or ends
  std::optional<RelaxedLandmarks> reached_;  // from the state that is looked at
};

}  // namespace pizarra::planner
