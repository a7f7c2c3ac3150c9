#include "agents/planner/fast/proved_shortest.hpp"

#include <algorithm>

#include "agents/planner/guided/guided_search.hpp"

namespace pizarra::planner {

namespace {

// The bound of one state takes as long as the distances of some thirty. Where it is exact, it is asked a little more
// than once an action; where it is not, other ways to a shorter plan are better.
constexpr std::size_t nodes_a_bound = 30;
constexpr std::size_t bounds_an_action = 4;
constexpr std::size_t most_table_bytes = 64 << 20;

std::vector<FactGroup> wide(const std::vector<std::vector<FactIndex>>& groups) {
  std::vector<FactGroup> out;
  for (const std::vector<FactIndex>& group : groups) out.emplace_back(group.begin(), group.end());
  return out;
}

}  // namespace

std::optional<Outcome> ProvedShortest::shorter_than(std::size_t actions) {
  const std::size_t table_bytes = problem_.facts.size() * problem_.facts.size() / 8;
  lacked_memory_ = table_bytes <= most_table_bytes && table_bytes > spent_.bytes() / 4;
  if (lacked_memory_ || table_bytes > most_table_bytes) return std::nullopt;
  const std::vector<FactGroup> groups = wide(nearness_.invariants.groups());
  const Exclusions exclusions(problem_, groups);
  const std::optional<FactGroup> resource = resource_of_all(problem_, exclusions.actions(), groups);
  if (!resource || !exclusions.allow(problem_.goals)) return std::nullopt;
  LandmarkBound bound(problem_, exclusions, *resource, spent_.cancelled());
  if (spent_.stopped()) return std::nullopt;
  proved_ = bound.from(problem_.initials) == actions;
  if (proved_) return std::nullopt;

  GuidedSearch search(problem_, nearness_, bound, nullptr);
  const std::size_t bounds = std::min(bounds_an_action * actions, spent_.nodes_left() / nodes_a_bound);
  Outcome outcome = search.run({.nodes = bounds, .bytes = spent_.bytes() / 2}, spent_.cancelled());
  spent_.count(outcome.nodes * nodes_a_bound);
  if (outcome.kind != Outcome::Kind::plan) return std::nullopt;
  proved_ = true;
  if (outcome.steps.size() >= actions) return std::nullopt;
  return outcome;
}

}  // namespace pizarra::planner
