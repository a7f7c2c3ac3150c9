#pragma once

// The facts that could be reached if nothing were ever deleted: the question behind landmarks, asked many times of one
// problem.
//
//   RelaxedReach reach(problem, allowed);            // allowed: the actions that are there at all
//   reach.from(state, forbidden);
//   reach.facts().test(goal); reach.actions().test(3);

#include <cstdint>

#include "agents/planner/task/problem.hpp"
#include "agents/planner/task/rows.hpp"

namespace pizarra::planner {

class RelaxedReach {
 public:
  RelaxedReach(const Problem& problem, const Bits& allowed);

  // The facts and actions reached from the state without the forbidden actions, until the next call.
  void from(const Bits& state, const Bits& forbidden);
  const Bits& facts() const { return facts_; }
  const Bits& actions() const { return actions_; }

 private:
  void take(std::size_t action, const Bits& forbidden);

  const Problem& problem_;
  Rows adds_;                              // of every action
  Rows needed_by_;                         // of every fact: allowed actions
  std::vector<std::uint32_t> need_count_;  // of every action: its preconditions
  std::vector<std::size_t> needless_;      // allowed actions without preconditions
  std::vector<std::uint32_t> missing_;
  std::vector<std::size_t> open_;
  Bits facts_, actions_;
};

}  // namespace pizarra::planner
