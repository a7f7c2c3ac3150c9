#include "agents/planner/problem.hpp"

#include <algorithm>

namespace pizarra {

bool interfere(const GroundAction& a, const GroundAction& b) {
  const auto spoils = [](const GroundAction& by, const GroundAction& of) {
    return std::ranges::any_of(by.deletes, [&](std::size_t fact) {
      return std::ranges::binary_search(of.preconditions, fact) || std::ranges::binary_search(of.adds, fact);
    });
  };
  return spoils(a, b) || spoils(b, a);
}

PlanSteps steps_of(const Problem& problem, const std::vector<std::vector<std::size_t>>& steps) {
  PlanSteps named;
  for (const std::vector<std::size_t>& step : steps) {
    named.emplace_back();
    for (const std::size_t action : step) named.back().push_back(problem.actions[action].name);
  }
  return named;
}

}  // namespace pizarra
