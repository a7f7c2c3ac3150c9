#include "agents/planner/problem.hpp"

#include <algorithm>

namespace pizarra {

bool is_subtype(const std::vector<PlanningType>& types, const std::string& type, const std::string& wanted) {
  std::vector<std::string> above{type};
  for (std::size_t i = 0; i < above.size(); ++i) {
    if (above[i] == wanted) return true;
    for (const PlanningType& known : types) {
      if (known.name != above[i] || std::ranges::find(above, known.parent) != above.end()) continue;
      above.push_back(known.parent);
    }
  }
  return false;
}

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
