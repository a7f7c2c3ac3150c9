#include "agents/planner/task/problem.hpp"

#include <algorithm>

namespace pizarra::planner {

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

std::vector<Bits> interference(const Problem& problem) {
  const std::size_t count = problem.actions.size();
  std::vector<Bits> touched_by(problem.facts.size(), Bits(count));  // who needs or adds a fact
  for (std::size_t i = 0; i < count; ++i) {
    for (const std::size_t fact : problem.actions[i].preconditions) touched_by[fact].set(i);
    for (const std::size_t fact : problem.actions[i].adds) touched_by[fact].set(i);
  }
  std::vector<Bits> interfering(count, Bits(count));
  for (std::size_t i = 0; i < count; ++i) {
    for (const std::size_t fact : problem.actions[i].deletes) interfering[i] |= touched_by[fact];
    interfering[i].reset(i);
  }
  for (std::size_t i = 0; i < count; ++i) {
    interfering[i].for_each([&](std::size_t other) { interfering[other].set(i); });
  }
  return interfering;
}

void apply(const GroundAction& action, Bits& state) {
  for (const std::size_t fact : action.deletes) state.reset(fact);
  for (const std::size_t fact : action.adds) state.set(fact);
}

Bits after(const Bits& state, const GroundAction& action) {
  Bits next = state;
  apply(action, next);
  return next;
}

bool applicable(const GroundAction& action, const Bits& state) {
  return std::ranges::all_of(action.preconditions, [&](std::size_t fact) { return state.test(fact); });
}

PlanSteps steps_of(const Problem& problem, const std::vector<std::vector<std::size_t>>& steps) {
  PlanSteps named;
  for (const std::vector<std::size_t>& step : steps) {
    named.emplace_back();
    for (const std::size_t action : step) named.back().push_back(problem.actions[action].name);
  }
  return named;
}

}  // namespace pizarra::planner
