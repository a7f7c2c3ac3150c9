#include "agents/planner/fast/plan_shape.hpp"

#include <algorithm>
#include <optional>

namespace pizarra {

namespace {

// The plan without the action at `left_out` and all that cannot be done without it, where it still reaches the goals.
std::optional<std::vector<ActionIndex>> without(const CompactProblem& problem, const std::vector<ActionIndex>& plan,
                                                std::size_t left_out, Bits state) {
  std::vector<ActionIndex> rest(plan.begin(), plan.begin() + static_cast<std::ptrdiff_t>(left_out));
  for (std::size_t i = left_out + 1; i < plan.size(); ++i) {
    if (!problem.applicable(plan[i], state)) continue;
    problem.apply(plan[i], state);
    rest.push_back(plan[i]);
  }
  if (!problem.goals().subset_of(state)) return std::nullopt;
  return rest;
}

bool comes_after(const GroundAction& later, const GroundAction& earlier) {
  const auto needed = [&](std::size_t fact) { return std::ranges::binary_search(later.preconditions, fact); };
  return std::ranges::any_of(earlier.adds, needed) || interfere(later, earlier);
}

}  // namespace

std::vector<ActionIndex> without_idle_actions(const CompactProblem& problem, std::vector<ActionIndex> plan) {
  Bits state = problem.initials();
  for (std::size_t i = 0; i < plan.size();) {
    std::optional<std::vector<ActionIndex>> shorter = without(problem, plan, i, state);
    if (shorter) {
      plan = std::move(*shorter);
    } else {
      problem.apply(plan[i++], state);
    }
  }
  return plan;
}

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

}  // namespace pizarra
