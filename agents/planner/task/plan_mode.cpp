#include "agents/planner/task/plan_mode.hpp"

namespace pizarra::planner {

std::string_view name_of(PlanMode mode) { return mode == PlanMode::optimal ? "optimal" : "fast"; }

PlanMode mode_for(const Problem& problem) {
  return problem.actions.size() <= most_actions_for_optimal ? PlanMode::optimal : PlanMode::fast;
}

}  // namespace pizarra::planner
