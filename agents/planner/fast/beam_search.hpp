#pragma once

// A plan of fewer actions than a given number, one action after another. After each action it keeps a bounded number of
// states: those that seem nearest to the goals.
//
//   BeamSearch search(problem, estimate, spent, seed);
//   if (search.run(64, 30) == SearchEnd::found) use(search.plan());      // 64 states at a time, at most 30 actions
//
// `exhausted` proves nothing unless `complete()`: then no state had to be left out, and there is no such plan.

#include <unordered_set>

#include "agents/planner/distance/landmark_estimate.hpp"
#include "agents/planner/fast/search_budget.hpp"

namespace pizarra::planner {

class BeamSearch {
 public:
  // The arguments outlive the search. The seed decides among states that seem equally near.
  BeamSearch(const CompactProblem& problem, LandmarkEstimate& estimate, SearchBudget& spent, std::uint64_t seed);

  SearchEnd run(std::size_t width, std::size_t most_actions);
  const std::vector<ActionIndex>& plan() const { return plan_; }
  bool complete() const { return complete_; }

 private:
  struct Kept {
    Bits state;
    std::uint64_t hash;
    std::uint32_t step;  // in steps_
  };
  struct Step {
    std::uint32_t from;
    ActionIndex action;
  };
  struct Candidate {
    Distance distance;
    std::uint64_t tie;
    std::uint64_t hash;
    std::uint32_t parent;  // in the layer
    ActionIndex action;
  };
  void expand(std::uint32_t parent);
  void keep_nearest(std::size_t width);
  std::uint64_t hash_after(const Kept& kept, ActionIndex action) const;
  void take_plan(std::uint32_t step);

  const CompactProblem& problem_;
  LandmarkEstimate& estimate_;
  SearchBudget& spent_;
  const std::uint64_t seed_;
  std::vector<std::uint64_t> keys_;  // of every fact; a state's hash is the xor of its facts' keys
  std::vector<Kept> layer_, next_layer_;
  std::vector<Candidate> candidates_;
  std::unordered_set<std::uint64_t> seen_;  // looked up only
  std::vector<Step> steps_;
  std::vector<ActionIndex> plan_;
  bool complete_ = true;
};

}  // namespace pizarra::planner
