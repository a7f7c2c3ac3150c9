#pragma once

// A planner for the coordinator's tests that stands on nothing it could share a mistake with: breadth first over every
// way to ground every operator.
//
//   const std::optional<std::vector<Datum>> plan = shortest_plan(domain, types, initials, goals);

#include <optional>
#include <vector>

#include "agents/coordinator/plan/task_domain.hpp"

namespace pizarra::coordinator {

// `types` as in (get-facts (types (OBJECT TYPE) ...) ...). None where nothing leads to the goal.
std::optional<std::vector<Datum>> shortest_plan(const TaskDomain& domain, const Datum& types, const Facts& initials,
                                                const Facts& goals);

}  // namespace pizarra::coordinator
