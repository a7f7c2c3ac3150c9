#pragma once

// States from which the goals are out of reach: regression from the goals, in pairs of facts, as Exclusions are
// progression (Alcázar & Torralba, "A reminder about the importance of computing and exploiting invariants in
// planning", 2015).
//
//   const DeadEnds dead_ends(problem, exclusions);
//   if (dead_ends.contain(problem.initials)) ...        // no plan exists

#include "agents/planner/reach/exclusions.hpp"

namespace pizarra::planner {

class DeadEnds {
 public:
  // Worthless once cancelled() was true.
  DeadEnds(
      const Problem& problem, const Exclusions& exclusions,
      const std::function<bool()>& cancelled = [] { return false; });

  // True: proved. The state respects the exclusions.
  bool contain(const Bits& state) const;

 private:
  bool grow(const Problem& problem, const Exclusions& exclusions, const std::function<bool()>& cancelled);
  bool join(std::size_t fact, const Bits& others);

  std::vector<Bits> hopeful_;  // of every fact: those beside which the goals may be within reach, itself included
};

}  // namespace pizarra::planner
