#pragma once

// How far a state is from the goals: the length of a plan that would do if nothing were ever deleted.
//
//   RelaxedPlan relaxed(problem);
//   if (relaxed.look_at(state)) climb(relaxed.length(), relaxed.helpful());
//
// The next layer may use all facts that one layer of actions makes true; of the actions that make a fact true first,
// the plan has the one whose preconditions come soonest. Helpful is what can be done at once and makes something true
// that the plan begins with. (Hoffmann and Nebel 2001.)
//
// Asking costs a look at every action, far more than `LandmarkEstimate` does; it sees what that is blind to: that one
// of several actions has to bring a fact about, whichever it is.

#include "agents/planner/distance/compact_problem.hpp"

namespace pizarra::planner {

class RelaxedPlan {
 public:
  // The problem outlives the plan.
  explicit RelaxedPlan(const CompactProblem& problem);

  // Whether the goals can be reached from the state at all, if nothing were deleted. The rest is of the last state that
  // was looked at and from which they can.
  bool look_at(const Bits& state);
  std::size_t length() const { return length_; }
  const std::vector<ActionIndex>& helpful() const { return helpful_; }  // ascending

 private:
  bool reach_goals(const Bits& state);
  void do_in_layer(std::uint32_t layer, ActionIndex action);
  void gather(const Bits& state);
  void need(FactIndex fact);

  const CompactProblem& problem_;
  struct Awaiting {
    std::uint32_t missing;     // preconditions not reached yet
    std::uint32_t difficulty;  // the layers of the others, summed
  };
  std::vector<Awaiting> at_first_;     // of an action
  std::vector<ActionIndex> needless_;  // those without
  std::vector<FactIndex> goals_;

  struct Reached {
    std::uint32_t layer;
    std::uint32_t difficulty;  // of the action
    ActionIndex by;
    bool needed;
  };
  std::vector<Reached> reached_;    // of a fact
  std::vector<Awaiting> awaiting_;  // of an action
  std::vector<FactIndex> layer_, next_layer_;
  std::vector<FactIndex> open_;  // needed, and not looked at yet
  std::vector<char> planned_;    // of an action
  std::size_t length_ = 0;
  std::vector<ActionIndex> helpful_;
};

}  // namespace pizarra::planner
