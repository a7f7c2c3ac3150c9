#pragma once

// All that is needed to ask how far states of one problem are from its goals.
//
//   Nearness nearness(problem);
//   nearness.estimate.look_at(state);

#include "agents/planner/distance/landmark_estimate.hpp"

namespace pizarra {

struct Nearness {
  explicit Nearness(const Problem& problem)
      : compact(problem), invariants(problem, compact), estimate(compact, invariants) {}
  Nearness(const Nearness&) = delete;
  Nearness& operator=(const Nearness&) = delete;

  const CompactProblem compact;
  const InvariantGroups invariants;
  LandmarkEstimate estimate;
};

}  // namespace pizarra
