#include "agents/planner/fast/plan_shape.hpp"

#include <algorithm>

namespace pizarra::planner {

namespace {

bool comes_after(const GroundAction& later, const GroundAction& earlier) {
  const auto needed = [&](std::size_t fact) { return std::ranges::binary_search(later.preconditions, fact); };
  return std::ranges::any_of(earlier.adds, needed) || interfere(later, earlier);
}

}  // namespace

std::vector<std::vector<std::size_t>> in_parallel(const Problem& problem, const std::vector<ActionIndex>& plan) {
  std::vector<std::vector<std::size_t>> steps;
  for (const ActionIndex index : plan) {
    std::size_t step = steps.size();
    const GroundAction& action = problem.actions[index];
    const auto free_of = [&](const std::vector<std::size_t>& others) {
      return std::ranges::none_of(others,
                                  [&](std::size_t other) { return comes_after(action, problem.actions[other]); });
    };
    while (step > 0 && free_of(steps[step - 1])) --step;
    if (step == steps.size()) steps.emplace_back();
    steps[step].push_back(index);
  }
  for (std::vector<std::size_t>& step : steps) std::ranges::sort(step);
  return steps;
}

}  // namespace pizarra::planner
