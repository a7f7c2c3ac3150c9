#include "agents/planner/optimal/optimal_planner.hpp"

#include <algorithm>

namespace pizarra {

namespace {

// Of resources for a bound, those that the most facts speak of are looked at.
constexpr std::size_t max_resources = 8;

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
  for (std::size_t i = 0; i < culprits.size() && culprits.size() > 1;) {
    std::vector<std::size_t> without = culprits;
    without.erase(without.begin() + static_cast<std::ptrdiff_t>(i));
    fewer.goals.clear();
    for (const std::size_t goal : without) fewer.goals.set(goal);
    if (OptimalSearch(fewer).run(budget, cancelled).kind == Outcome::Kind::none) {
      culprits = std::move(without);
    } else {
      ++i;
    }
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
