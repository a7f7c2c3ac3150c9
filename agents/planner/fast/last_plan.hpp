#pragma once

// The plan made last, for when the world is no longer, or not quite, where it began.
//
//   const LastPlan last(problem, outcome.steps, PlanMode::fast);
//   if (const auto rest = last.rest_from(state)) ...            // what is left to do, in microseconds
//   if (const auto plan = last.repaired(compact, state)) ...    // a short way back to it, and what is left from there

#include <optional>

#include "agents/planner/distance/compact_problem.hpp"
#include "agents/planner/task/plan_mode.hpp"

namespace pizarra::planner {

class LastPlan {
 public:
  using Steps = std::vector<std::vector<std::size_t>>;
  // A plan of the problem from its initial facts.
  LastPlan(const Problem& problem, Steps steps, PlanMode mode);

  PlanMode mode() const { return mode_; }
  // The shortest end of the plan that reaches the goals from this state. Of a plan with the fewest steps, only the end
  // that is as short as can be: the one from this very state.
  std::optional<Steps> rest_from(const Bits& state) const;
  // The actions of a plan that first goes to where an end of this plan works; of such ways, as far as they are looked
  // for, the one with the fewest actions. None where all are too far.
  std::optional<std::vector<ActionIndex>> repaired(const CompactProblem& problem, const Bits& state) const;

 private:
  std::optional<std::size_t> end_that_works(const Bits& state) const;

  const Steps steps_;
  const PlanMode mode_;
  // Before every step, and after the last: what holds, and what must hold for the rest to work.
  std::vector<Bits> states_, needed_;
  std::vector<std::size_t> actions_left_;
};

}  // namespace pizarra::planner
