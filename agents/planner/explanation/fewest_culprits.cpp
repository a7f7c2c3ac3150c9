#include "agents/planner/explanation/fewest_culprits.hpp"

#include <algorithm>

#include "agents/planner/optimal/optimal_search.hpp"

namespace pizarra::planner {

namespace {

// An explanation is not worth more work, and takes some before its first node.
constexpr std::size_t most_nodes_for_blame = 400'000;
constexpr std::size_t nodes_of_an_attempt = 1'000;

}  // namespace

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

}  // namespace pizarra::planner
