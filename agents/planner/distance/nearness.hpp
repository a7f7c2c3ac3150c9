#pragma once

// All that is needed to ask how far states of one problem are from its goals.
//
//   Nearness nearness(problem);
//   nearness.estimate.look_at(state);
//   if (nearness.begin_from(elsewhere)) ...         // of the same problem, with other initial facts

#include "agents/planner/distance/landmark_estimate.hpp"

namespace pizarra::planner {

struct Nearness {
  // Its parts are incomplete if this was cancelled.
  explicit Nearness(
      const Problem& problem, const std::function<bool()>& cancelled = [] { return false; })
      : compact(problem), invariants(problem, compact, cancelled), estimate(compact, invariants, cancelled) {}
  Nearness(const Nearness&) = delete;
  Nearness& operator=(const Nearness&) = delete;

  // False where what was proved does not hold from there: it must then not be used.
  bool begin_from(const Bits& initials) {
    compact.begin_from(initials);
    return invariants.hold_in(initials);
  }

  CompactProblem compact;
  const InvariantGroups invariants;
  LandmarkEstimate estimate;
};

}  // namespace pizarra::planner
