#pragma once

// The bench's own problems: the same for the same seed, everywhere.
//
//   const PlanningTask task = blocks_problem(20, 1);

#include <cstdint>

#include "agents/planner/task/planning_task.hpp"

namespace pizarra::bench {

// Random piles of all the blocks to random piles.
planner::PlanningTask blocks_problem(std::size_t blocks, std::uint64_t seed);
// A tower of discs from the first peg to the third.
planner::PlanningTask hanoi_problem(std::size_t discs);
// Balls from one room to the other, two grippers; the classic gripper N has 2 N + 2 balls.
planner::PlanningTask gripper_problem(std::size_t balls);
// Parcels between two-place cities, a truck in each, one aeroplane.
planner::PlanningTask logistics_problem(std::size_t cities, std::size_t parcels, std::uint64_t seed);

}  // namespace pizarra::bench
