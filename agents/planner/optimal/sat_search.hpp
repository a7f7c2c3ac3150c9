#pragma once

// The fewest parallel steps by satisfiability: one number of steps after another, from the first that the planning
// graphs, forwards and backwards, do not rule out.
//
//   SatSearch search(problem, exclusions, interferes, regression, budget, cancelled);
//   Outcome outcome = search.run(at_least);
//
// A plan found is one of fewest steps, because fewer were proved impossible on the way. Without a plan the graphs prove
// it, or the nogoods of the backward search, which is asked now and then once the graphs have levelled off.
// Budget::nodes counts every conflict of the solver a hundredfold.

#include "agents/planner/optimal/step_encoding.hpp"

namespace pizarra {

class SatSearch {
 public:
  // The arguments outlive it; `interferes` is interference(problem), and the regression graph may be used again.
  SatSearch(const Problem& problem, const Exclusions& exclusions, const std::vector<Bits>& interferes,
            RegressionGraph& regression, const Budget& budget, const std::function<bool()>& cancelled);

  Outcome run(std::size_t at_least);

 private:
  bool build_graphs(Outcome& outcome);
  bool possible(std::size_t steps) const;
  // Whether the search is over, with its end in the outcome.
  bool try_steps(const StepKnowledge& knowledge, std::size_t steps, Outcome& outcome);
  bool prove_none(Outcome& outcome);

  const Problem& problem_;
  const Exclusions& exclusions_;
  const std::vector<Bits>& interferes_;
  RegressionGraph& regression_;
  const Budget& budget_;
  const std::function<bool()>& cancelled_;
  PlanningGraph progression_;
  std::size_t nodes_ = 0;
};

}  // namespace pizarra
