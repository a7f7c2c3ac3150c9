#pragma once

// Some plan, soon: always goes on from the state that seems nearest to the goals, of equals from the one found first.
//
//   LandmarkEstimate estimate(problem, invariants);
//   GreedySearch search(problem, estimate, spent);
//   std::optional<SearchEnd> end = search.run(200);            // none: 200 states in a row were no nearer than any
//   before if (!end) end = search.run();                              // goes on from there if (end ==
//   SearchEnd::found) use(search.plan());
//
// Looks at every state that can be reached before it says that there is no plan.

#include <limits>
#include <queue>
#include <unordered_set>

#include "agents/planner/distance/landmark_estimate.hpp"
#include "agents/planner/fast/search_budget.hpp"

namespace pizarra::planner {

class GreedySearch {
 public:
  // The arguments outlive the search.
  GreedySearch(const CompactProblem& problem, LandmarkEstimate& estimate, SearchBudget& spent)
      : problem_(problem), estimate_(estimate), spent_(spent) {}

  // `exhausted`: there is no plan. Without patience for states in vain it is always one of the four ends.
  std::optional<SearchEnd> run(std::size_t patience);
  SearchEnd run() { return *run(std::numeric_limits<std::size_t>::max()); }
  const std::vector<ActionIndex>& plan() const { return plan_; }

 private:
  struct Reached {
    const Bits* state;
    std::uint32_t from;
    ActionIndex action;
  };
  struct Candidate {
    Distance distance;
    std::uint32_t serial;
    std::uint32_t from;
    ActionIndex action;
    bool operator<(const Candidate& other) const {  // the queue's top is its greatest
      return distance != other.distance ? distance > other.distance : serial > other.serial;
    }
  };
  bool reach_nearest();
  bool reach(const Candidate& candidate);
  void expand(std::uint32_t index);

  const CompactProblem& problem_;
  LandmarkEstimate& estimate_;
  SearchBudget& spent_;
  std::vector<Reached> reached_;
  std::unordered_set<Bits, HashBits> states_;  // looked up only
  std::priority_queue<Candidate> candidates_;
  std::uint32_t serial_ = 0;
  Distance nearest_ = std::numeric_limits<Distance>::max();  // of all states gone on from
  std::vector<ActionIndex> plan_;
};

}  // namespace pizarra::planner
