#pragma once

// A last pass over every engine's plan, which may hold more than it needs.
//
//   outcome.steps = without_idle_actions(problem, std::move(steps));

#include "agents/planner/task/problem.hpp"

namespace pizarra::planner {

// Leaves out every action that, with those which need what it made true, is not needed for the goals (Nakhost and
// Mueller 2010). What stays, stays in its step; steps that are empty then are left out too.
std::vector<std::vector<std::size_t>> without_idle_actions(const Problem& problem,
                                                           const std::vector<std::vector<std::size_t>>& steps);

}  // namespace pizarra::planner
