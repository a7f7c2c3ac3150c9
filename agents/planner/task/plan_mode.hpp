#pragma once

// Chooses the aim that suits a problem's size: the fewest parallel steps, proved, or a plan soon.
//
//   if (mode_for(problem) == PlanMode::optimal) ...

#include <string_view>

#include "agents/planner/task/problem.hpp"

namespace pizarra::planner {

enum class PlanMode : std::uint8_t { optimal, fast };
inline std::string_view name_of(PlanMode mode) { return mode == PlanMode::optimal ? "optimal" : "fast"; }

// Where satisfiability has to find the fewest steps, 2000 actions (20 parcels in 8 cities) take seconds and 4000 more
// than anyone waits, as measured. Where one resource guides the search, the fast planner proves the fewest, too.
constexpr std::size_t most_actions_for_optimal = 3000;
inline PlanMode mode_for(const Problem& problem) {
  return problem.actions.size() <= most_actions_for_optimal ? PlanMode::optimal : PlanMode::fast;
}

}  // namespace pizarra::planner
