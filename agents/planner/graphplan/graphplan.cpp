#include "agents/planner/graphplan/graphplan.hpp"

#include <fmt/format.h>

#include "agents/planner/graphplan/backward_search.hpp"

namespace pizarra::planner {

namespace {

// Goals that the level rules out: the first that is not there, or else the first two that exclude each other.
std::vector<std::size_t> ruled_out(const Bits& goals, const FactLevel& level) {
  std::vector<std::size_t> missing, pair;
  goals.for_each([&](std::size_t goal) {
    if (!level.present.test(goal) && missing.empty()) missing.push_back(goal);
    if (!missing.empty() || !pair.empty()) return;
    goals.for_each([&](std::size_t other) {
      if (pair.empty() && other > goal && level.mutex[goal].test(other)) pair = {goal, other};
    });
  });
  return missing.empty() ? pair : missing;
}

}  // namespace

Outcome Graphplan::solve(const Problem& problem, const Budget& budget, const std::function<bool()>& cancelled) {
  if (problem.goals.subset_of(problem.initials)) {
    return {.kind = Outcome::Kind::plan};
  }
  const std::string memory = fmt::format("{} MB of memory", budget.bytes >> 20);
  if (PlanningGraph::base_bytes(problem) > budget.bytes) return {.spent = memory};
  PlanningGraph graph(problem);
  BackwardSearch search(problem, graph, budget, cancelled);
  for (std::size_t level = 1; level <= budget.levels; ++level) {
    if (cancelled()) return {.kind = Outcome::Kind::cancelled, .nodes = search.nodes()};
    if (graph.bytes() + graph.bytes_per_level() > budget.bytes) return {.spent = memory, .nodes = search.nodes()};
    graph.expand();
    const std::vector<std::size_t> excluded = ruled_out(problem.goals, graph.fact_level(level));
    if (!excluded.empty() && graph.levelled_off())
      return {.kind = Outcome::Kind::none, .culprits = excluded, .nodes = search.nodes()};
    if (!excluded.empty()) continue;

    if (search.reach(problem.goals, level)) {
      return {.kind = Outcome::Kind::plan, .steps = search.steps(), .nodes = search.nodes()};
    }
    if (!search.stopped() && graph.levelled_off()) {
      const std::optional<std::vector<std::size_t>> culprits = search.excluded_for_ever(problem.goals, level);
      if (culprits) return {.kind = Outcome::Kind::none, .culprits = *culprits, .nodes = search.nodes()};
    }
    if (search.cancelled()) return {.kind = Outcome::Kind::cancelled, .nodes = search.nodes()};
    if (search.stopped()) return {.spent = search.spent(), .nodes = search.nodes()};
  }
  return {.spent = fmt::format("{} levels", budget.levels), .nodes = search.nodes()};
}

}  // namespace pizarra::planner
