#include "agents/planner/distance/impossible_goals.hpp"

namespace pizarra::planner {

namespace {

// Two facts of a list that exclude each other, the first such; empty where none do.
template <class Facts>
std::vector<std::size_t> excluding_pair(const Facts& facts, const InvariantGroups& invariants) {
  for (std::size_t i = 0; i < facts.size(); ++i) {
    for (std::size_t j = i + 1; j < facts.size(); ++j) {
      if (invariants.exclude(facts[i], facts[j])) return {facts[i], facts[j]};
    }
  }
  return {};
}

Bits reached_by_possible_actions(const CompactProblem& problem, const InvariantGroups& invariants) {
  Bits reached(problem.facts());
  std::vector<FactIndex> waiting;
  const auto reach = [&](std::size_t fact) {
    if (reached.test(fact)) return;
    reached.set(fact);
    waiting.push_back(static_cast<FactIndex>(fact));
  };
  const auto take = [&](ActionIndex action) {
    if (!excluding_pair(problem.preconditions(action), invariants).empty()) return;
    for (const FactIndex fact : problem.adds(action)) reach(fact);
  };
  std::vector<std::size_t> missing(problem.actions());
  for (ActionIndex action = 0; action < problem.actions(); ++action) {
    missing[action] = problem.preconditions(action).size();
    if (missing[action] == 0) take(action);
  }
  problem.initials().for_each(reach);
  while (!waiting.empty()) {
    const FactIndex fact = waiting.back();
    waiting.pop_back();
    for (const ActionIndex action : problem.needing(fact)) {
      if (--missing[action] == 0) take(action);
    }
  }
  return reached;
}

}  // namespace

std::vector<std::size_t> impossible_goals(const CompactProblem& problem, const InvariantGroups& invariants) {
  std::vector<FactIndex> goals;
  problem.goals().for_each([&](std::size_t goal) { goals.push_back(static_cast<FactIndex>(goal)); });
  const Bits reached = reached_by_possible_actions(problem, invariants);
  for (const FactIndex goal : goals) {
    if (!reached.test(goal)) return {goal};
  }
  return excluding_pair(goals, invariants);
}

}  // namespace pizarra::planner
