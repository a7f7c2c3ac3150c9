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

Outcome gave_up(std::string spent, std::size_t nodes) {
  return {.kind = Outcome::Kind::gave_up, .steps = {}, .culprits = {}, .spent = std::move(spent), .nodes = nodes};
}

Outcome no_plan(std::vector<std::size_t> culprits, std::size_t nodes) {
  return {.kind = Outcome::Kind::none, .steps = {}, .culprits = std::move(culprits), .spent = {}, .nodes = nodes};
}

Outcome stopped_by_caller(const BackwardSearch& search) {
  return {.kind = Outcome::Kind::cancelled, .steps = {}, .culprits = {}, .spent = {}, .nodes = search.nodes()};
}

}  // namespace

Outcome Graphplan::solve(const Problem& problem, const Budget& budget, const std::function<bool()>& cancelled) {
  if (problem.goals.subset_of(problem.initials)) {
    return {.kind = Outcome::Kind::plan, .steps = {}, .culprits = {}, .spent = {}, .nodes = 0};
  }
  const std::string memory = fmt::format("{} MB of memory", budget.bytes >> 20);
  if (PlanningGraph::base_bytes(problem) > budget.bytes) return gave_up(memory, 0);
  PlanningGraph graph(problem);
  BackwardSearch search(problem, graph, budget, cancelled);
  for (std::size_t level = 1; level <= budget.levels; ++level) {
    if (cancelled()) return stopped_by_caller(search);
    if (graph.bytes() + graph.bytes_per_level() > budget.bytes) return gave_up(memory, search.nodes());
    graph.expand();
    const std::vector<std::size_t> excluded = ruled_out(problem.goals, graph.fact_level(level));
    if (!excluded.empty() && graph.levelled_off()) return no_plan(excluded, search.nodes());
    if (!excluded.empty()) continue;

    if (search.reach(problem.goals, level)) {
      return {
          .kind = Outcome::Kind::plan, .steps = search.steps(), .culprits = {}, .spent = {}, .nodes = search.nodes()};
    }
    if (!search.stopped() && graph.levelled_off()) {
      const std::optional<std::vector<std::size_t>> culprits = search.excluded_for_ever(problem.goals, level);
      if (culprits) return no_plan(*culprits, search.nodes());
    }
    if (search.cancelled()) return stopped_by_caller(search);
    if (search.stopped()) return gave_up(search.spent(), search.nodes());
  }
  return gave_up(fmt::format("{} levels", budget.levels), search.nodes());
}

}  // namespace pizarra::planner
