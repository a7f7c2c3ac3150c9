#pragma once

// How many actions the usual way with blocks takes, which knows what blocks are: whatever block can go to its last
// place goes there; where none can, one that is in the way goes to the table. The measure for a planner that does not
// know.
//
//   const std::size_t actions = blocks_greedy_actions(blocks_problem(50, 1));

#include "agents/planner/task/planning_task.hpp"

namespace pizarra::bench {

std::size_t blocks_greedy_actions(const planner::PlanningTask& task);

}  // namespace pizarra::bench
