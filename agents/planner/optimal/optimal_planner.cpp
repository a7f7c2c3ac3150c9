#include "agents/planner/optimal/optimal_planner.hpp"

#include <algorithm>

namespace pizarra {

namespace {

// Of resources for a bound, those that the most facts speak of are looked at.
constexpr std::size_t max_resources = 8;
// An explanation is not worth more work, and takes some before its first node.
constexpr std::size_t most_nodes_for_blame = 400'000;
constexpr std::size_t nodes_of_an_attempt = 1'000;

}  // namespace

Outcome OptimalPlanner::solve(const Problem& problem, const Budget& budget, const std::function<bool()>& cancelled) {
  Outcome outcome = OptimalSearch(problem).run(budget, cancelled);
  blame_fewest(problem, budget, cancelled, outcome);
  return outcome;
}

void blame_fewest(const Problem& problem, const Budget& budget, const std::function<bool()>& cancelled,
                  Outcome& outcome) {
  std::vector<std::size_t>& culprits = outcome.culprits;
  if (culprits.size() < 2) return;
  Problem fewer = problem;
  Budget left = budget;
  left.nodes = std::min(budget.nodes, most_nodes_for_blame);
  for (std::size_t i = 0; i < culprits.size() && culprits.size() > 1 && left.nodes > 0 && !cancelled();) {
    std::vector<std::size_t> without = culprits;
    without.erase(without.begin() + static_cast<std::ptrdiff_t>(i));
    fewer.goals.clear();
    for (const std::size_t goal : without) fewer.goals.set(goal);
    const Outcome tried = OptimalSearch(fewer).run(left, cancelled);
    left.nodes -= std::min(left.nodes, tried.nodes + nodes_of_an_attempt);
    if (tried.kind != Outcome::Kind::none) {
      ++i;
      continue;
    }
    // Those before it stay among them: what remains without one can be reached.
    culprits = tried.culprits;
    std::ranges::sort(culprits);
  }
}

std::optional<std::size_t> fewest_actions(const Problem& problem) {
  const Exclusions exclusions(problem);
  if (!exclusions.allow(problem.goals)) return std::nullopt;
  std::vector<FactGroup> groups = exclusion_groups(exclusions);
  std::ranges::stable_sort(groups, std::greater{}, &FactGroup::size);
  if (std::optional<FactGroup> all = resource_of_all(problem, exclusions)) groups.assign(1, std::move(*all));
  if (groups.size() > max_resources) groups.resize(max_resources);
  std::size_t fewest = 0;
  for (const FactGroup& group : groups) {
    const std::optional<std::size_t> steps = LandmarkBound(problem, exclusions, group).from(problem.initials);
    if (!steps) return std::nullopt;
    fewest = std::max(fewest, *steps);
  }
  return fewest;
}

}  // namespace pizarra
