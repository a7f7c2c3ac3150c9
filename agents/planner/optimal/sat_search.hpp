#pragma once

// The fewest parallel steps by satisfiability: one number of steps after another, from the first that the regression
// graph does not rule out.
//
//   SatSearch search(problem, exclusions);
//   Outcome outcome = search.run(at_least, budget, cancelled);
//   problem.initials = elsewhere;
//   outcome = search.run(at_least, budget, cancelled);             // cheaper: the solver has learned
//
// A plan found is one of fewest steps, because fewer were proved impossible on the way. Without a plan the graph proves
// it, or the nogoods of the backward search, which is asked now and then once the graph has levelled off.
// Budget::nodes counts every conflict of the solver a hundredfold.

#include <memory>
#include <optional>

#include "agents/planner/reach/regression_graph.hpp"

namespace pizarra::planner {

class SatSearch {
 public:
  // The arguments outlive it; the problem's initial facts may change meanwhile, and respect the exclusions.
  SatSearch(const Problem& problem, const Exclusions& exclusions);
  ~SatSearch();

  Outcome run(std::size_t at_least, const Budget& budget, const std::function<bool()>& cancelled);

 private:
  // One call of run().
  struct Run {
    const Budget& budget;
    const std::function<bool()>& cancelled;
    Outcome outcome;
    std::size_t nodes_left() const { return budget.nodes - std::min(outcome.nodes, budget.nodes); }
  };
  // Whether the run is over, with its end in the outcome.
  bool grow_graph(Run& run, std::size_t steps);
  bool try_steps(Run& run, std::size_t steps);
  bool prove_none(Run& run);

  const Problem& problem_;
  const Exclusions& exclusions_;
  const std::vector<Bits> interferes_;
  RegressionGraph regression_;
  struct Solver;
  std::unique_ptr<Solver> solver_;  // with all that it has learned
};

}  // namespace pizarra::planner
