#pragma once

// Some plan, soon, where goals can be worked off one by one: from every state to one that is nearer to the goals, by as
// few helpful actions as can be, with no way back.
//
//   HillClimbing climbing(problem, spent);
//   if (climbing.run() == SearchEnd::found) use(climbing.plan());
//
// `exhausted` proves nothing: no nearer state was found among the next ones, or helpful actions lead nowhere
// (enforced hill climbing, Hoffmann and Nebel 2001).

#include <unordered_set>

#include "agents/planner/distance/relaxed_plan.hpp"
#include "agents/planner/fast/search_budget.hpp"

namespace pizarra::planner {

class HillClimbing {
 public:
  // The arguments outlive the search.
  HillClimbing(const CompactProblem& problem, SearchBudget& spent)
      : problem_(problem), spent_(spent), relaxed_(problem) {}

  SearchEnd run();
  const std::vector<ActionIndex>& plan() const { return plan_; }

 private:
  struct Seen {
    Bits state;
    std::uint32_t from;
    ActionIndex action;
    std::vector<ActionIndex> helpful;
  };
  SearchEnd climb();
  bool visit(std::uint32_t from, ActionIndex action);

  const CompactProblem& problem_;
  SearchBudget& spent_;
  RelaxedPlan relaxed_;
  std::size_t distance_ = 0;
  std::vector<Seen> queue_;                    // the first is where the climb begins
  std::unordered_set<Bits, HashBits> states_;  // looked up only
  std::vector<ActionIndex> plan_;
};

}  // namespace pizarra::planner
