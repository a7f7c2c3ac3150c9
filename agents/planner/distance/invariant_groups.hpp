#pragma once

// Groups of facts of which at most one holds in any state that can be reached: where a block is, what a hand does.
//
//   const InvariantGroups invariants(problem, compact);
//   invariants.exclude(on_a_b, holding_a);     // true
//
// Found by guess and proof: a guess is a set of patterns over a predicate's arguments, such as (on X *) with
// (holding X) and (on-table X); it is proved when every action that adds a fact of a group takes another one of it
// away. A guess that fails is tried again with what the action takes away joined to it (Helmert 2009, section 5).

#include <functional>

#include "agents/planner/distance/compact_problem.hpp"

namespace pizarra::planner {

class InvariantGroups {
 public:
  // Where it is cancelled, there are fewer of them.
  InvariantGroups(
      const Problem& problem, const CompactProblem& compact,
      const std::function<bool()>& cancelled = [] { return false; });

  // Whether the two, different, facts never hold together, as far as it was found out.
  bool exclude(FactIndex a, FactIndex b) const;
  // Whether at most one fact of each group holds: then the same is true of all states that can be reached from there.
  bool hold_in(const Bits& state) const;
  std::span<const std::uint32_t> groups_of(FactIndex fact) const { return groups_of_[fact]; }
  const std::vector<std::vector<FactIndex>>& groups() const { return groups_; }

 private:
  std::vector<std::vector<FactIndex>> groups_;
  Rows groups_of_;  // ascending
};

}  // namespace pizarra::planner
