#pragma once

// The duties of every engine that plans in fewest steps, checked against the oracle on many random tasks.
//
//   expect_fewest_steps(engine, 60, random_gripper);

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/agents/planner/planning_domains.hpp"

namespace pizarra::planner {

inline const std::function<bool()> never = [] { return false; };

// The engine must say what the oracle says, with a valid plan as short, or culprits that are truly to blame.
void expect_fewest_steps(PlanEngine& engine, const PlanningTask& task);
// The engine's plan holds no action that could be left out with those which cannot be done without it.
void expect_no_idle_action(PlanEngine& engine, const PlanningTask& task);

// The task with only these goals.
PlanningTask blamed(const PlanningTask& task, const Problem& problem, const std::vector<std::size_t>& culprits);

// Goals over three blocks that rings, doubles and floating arms make impossible in many ways.
PlanningTask random_impossible_blocks(Random& random);

// From seeds 1, 2, ...
template <class Make, class Check>
void for_random_tasks(std::uint64_t seeds, Make make, Check check) {
  for (std::uint64_t seed = 1; seed <= seeds && !testing::Test::HasFailure(); ++seed) {
    Random random(seed);
    const PlanningTask task = make(random);
    SCOPED_TRACE(fmt::format("seed {}: {}", seed, show(task)));
    check(task);
  }
}

template <class Make>
void expect_fewest_steps(PlanEngine& engine, std::uint64_t seeds, Make make) {
  for_random_tasks(seeds, make, [&](const PlanningTask& task) { expect_fewest_steps(engine, task); });
}

}  // namespace pizarra::planner
