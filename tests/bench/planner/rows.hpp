#pragma once

// What the rows of this bench share. A row is a function that measures and says figures.

#include "tests/bench/figures.hpp"
#include "tests/bench/planner/measured_plan.hpp"
#include "tests/bench/planner/peers.hpp"

namespace pizarra::bench {

struct PlannerBench {
  Figures& figures;
  std::vector<PeerPlanner> peers;
  std::string pddl;  // a folder of benchmarks; empty: not given
  double limit_s = 60;
  bool quick = false;
  double most_memory_mb = 0;

  // Measures, and remembers the memory. A plan that does not come within the limit is said with that, as unmet.
  std::optional<MeasuredPlan> measure(const planner::PlanningTask& task, Mode mode, double limit);
  // A problem of --pddl, in the folder of its domain. Throws where it cannot be read.
  planner::PlanningTask file(const std::string& domain, const std::string& name) const;
};

void smallest(PlannerBench& bench);      // seconds in all, for a test
void optimal_own(PlannerBench& bench);   // our own problems, fewest steps
void optimal_pddl(PlannerBench& bench);  // those of --pddl
void fast_first(PlannerBench& bench);    // a first plan for 10 to 200 blocks
void fast_after_a_while(PlannerBench& bench);
void fast_others(PlannerBench& bench);  // other domains
void cell(PlannerBench& bench);         // what the coordinator feels

}  // namespace pizarra::bench
