#pragma once

// Shortens a plan by doing its own actions in another order.
//
//   PlanReordering reordering(problem, plan, random);
//   if (reordering.try_once()) use(reordering.plan());      // shorter
//   reordering.go_on_from(shorter_still);
//
// An attempt moves a piece of the plan elsewhere, or makes what a later action needs early enough for it to follow an
// earlier action at once. From there the plan is done again: always the first of the actions left that can be done. A
// later one that makes a goal true is preferred, if the others then still reach all goals. Actions that cannot be done
// any more are dropped: a block that was put aside goes straight to its place. Where none can be done, an action that
// was not in the plan may lead on: another block is put aside.

#include <optional>
#include <utility>

#include "agents/planner/distance/compact_problem.hpp"
#include "blackboard/time/random.hpp"

namespace pizarra::planner {

class PlanReordering {
 public:
  // The problem and the random numbers outlive it.
  PlanReordering(const CompactProblem& problem, std::vector<ActionIndex> plan, Random& random);

  // Whether the plan became shorter. One of equal length is taken too, so that the next attempt begins elsewhere.
  bool try_once();
  const std::vector<ActionIndex>& plan() const { return plan_; }
  // The plan's actions, or some of them.
  void go_on_from(const std::vector<ActionIndex>& plan) { plan_ = plan; }

 private:
  void move_a_piece();
  bool prepare_for_going_on();
  bool hurry(std::size_t end, std::pair<std::size_t, std::size_t> but, const Bits& holds, Bits& wanted);
  bool redo();
  std::optional<ActionIndex> next(const Bits& state);
  std::optional<ActionIndex> way_out(const Bits& state);
  bool plan_way_back(ActionIndex out, Bits state);
  bool makes_a_goal(ActionIndex action, const Bits& state) const;
  bool suffices(std::ptrdiff_t index, Bits state);

  const CompactProblem& problem_;
  Random& random_;
  std::vector<ActionIndex> plan_;
  Rows goal_makers_;                // of a fact: the actions that need it and add a goal
  std::vector<ActionIndex> order_;  // the plan with a piece moved; what is done is taken out
  std::size_t begin_ = 0;           // before it nothing was moved
  std::vector<ActionIndex> done_, rest_;
};

}  // namespace pizarra::planner
