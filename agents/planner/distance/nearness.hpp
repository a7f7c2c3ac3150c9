#pragma once

// All that is needed to ask how far states of one problem are from its goals.
//
//   Nearness nearness(problem);
//   nearness.estimate.look_at(state);

#include "agents/planner/distance/landmark_estimate.hpp"

namespace pizarra {

struct Nearness {
  // Of no use where this was cancelled.
  explicit Nearness(
      const Problem& problem, const std::function<bool()>& cancelled = [] { return false; })
      : compact(problem), invariants(problem, compact, cancelled), estimate(compact, invariants, cancelled) {}
  Nearness(const Nearness&) = delete;
  Nearness& operator=(const Nearness&) = delete;

  const CompactProblem compact;
  const InvariantGroups invariants;
  LandmarkEstimate estimate;
};

}  // namespace pizarra
