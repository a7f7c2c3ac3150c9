#pragma once

// All that is needed to ask how far states of one problem are from its goals.
//
//   Nearness nearness(problem);
//   nearness.unavoidable.look_at(state);

#include "agents/planner/distance/unavoidable.hpp"

namespace pizarra {

struct Nearness {
  explicit Nearness(const Problem& problem)
      : compact(problem), exclusive(problem, compact), unavoidable(compact, exclusive) {}
  Nearness(const Nearness&) = delete;
  Nearness& operator=(const Nearness&) = delete;

  const CompactProblem compact;
  const ExclusiveFacts exclusive;
  Unavoidable unavoidable;
};

}  // namespace pizarra
