#pragma once

// A plan of the fewest actions, and the proof, for large problems in which every action needs one resource. It is the
// guided search, knowing only the groups of facts that exclude each other, which are quickly found.
//
//   ProvedShortest shortest(problem, nearness, spent);
//   if (const std::optional<Outcome> plan = shortest.shorter_than(plan_length)) use(*plan);
//   if (shortest.proved()) return;        // nothing has fewer actions than the plan there was, or this one

#include <optional>

#include "agents/planner/distance/nearness.hpp"
#include "agents/planner/fast/search_budget.hpp"

namespace pizarra::planner {

class ProvedShortest {
 public:
  // The arguments outlive it.
  ProvedShortest(const Problem& problem, Nearness& nearness, SearchBudget& spent)
      : problem_(problem), nearness_(nearness), spent_(spent) {}

  // None: there is none, or it would take too long, or the problem is not of the kind.
  std::optional<Outcome> shorter_than(std::size_t actions);
  bool proved() const { return proved_; }
  bool lacked_memory() const { return lacked_memory_; }

 private:
  const Problem& problem_;
  Nearness& nearness_;
  SearchBudget& spent_;
  bool proved_ = false;
  bool lacked_memory_ = false;
};

}  // namespace pizarra::planner
