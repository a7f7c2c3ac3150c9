#include "agents/planner/optimal/optimal_search.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "agents/planner/optimal/step_search.hpp"

namespace pizarra::planner {

namespace {

// Beyond this many nodes satisfiability has better prospects.
constexpr std::size_t guided_nodes = 20'000;
constexpr std::size_t stepwise_nodes = 100'000;
// Beyond, it takes longer to find them than to search (10,000 facts of blocks world: 2.2 s, the search 1 s).
constexpr std::size_t most_facts_for_dead_ends = 5000;

Outcome none_because(std::vector<std::size_t> culprits) {
  return {.kind = Outcome::Kind::none, .culprits = std::move(culprits), .engine = "exclusions"};
}

// A goal that can never hold, or two that never hold together.
std::vector<std::size_t> excluded_goals(const Bits& goals, const Exclusions& exclusions) {
  std::vector<std::size_t> missing, pair;
  goals.for_each([&](std::size_t goal) {
    if (!exclusions.facts().test(goal)) {
      if (missing.empty()) missing = {goal};
      return;
    }
    Bits others = exclusions.with(goal);
    others &= goals;
    if (pair.empty()) others.for_each([&](std::size_t other) { pair = {goal, other}; });
  });
  std::ranges::sort(pair);
  return missing.empty() ? pair : missing;
}

// Of pairs of facts there are three: those that exclude each other, the same while their groups are looked for, and
// those beside which the goals are out of reach.
std::size_t table_bytes(const Problem& problem) { return 3 * problem.facts.size() * problem.facts.size() / 8; }

Outcome out_of_memory(const Budget& budget) {
  return {.kind = Outcome::Kind::gave_up, .spent = fmt::format("{} MB of memory", budget.bytes >> 20)};
}

Budget part(Budget budget, std::size_t nodes, std::size_t used) {
  budget.nodes = std::min(nodes, budget.nodes - std::min(used, budget.nodes));
  return budget;
}

}  // namespace

OptimalSearch::OptimalSearch(const Problem& problem) : problem_(problem) {}

// False when it was cancelled.
bool OptimalSearch::prepare(const std::function<bool()>& cancelled) {
  if (prepared_) return true;
  prepared_ = true;
  if (problem_.facts.size() <= most_facts_for_dead_ends) dead_ends_.emplace(problem_, *exclusions_, cancelled);
  if (cancelled()) return false;
  const std::vector<FactGroup> groups = exclusion_groups(*exclusions_, cancelled);
  if (cancelled()) return false;
  const std::optional<FactGroup> resource = resource_of_all(problem_, exclusions_->actions(), groups);
  if (!resource) return true;
  bound_.emplace(problem_, *exclusions_, *resource, cancelled);
  nearness_.emplace(problem_, cancelled);
  if (cancelled()) return false;
  guided_.emplace(problem_, *nearness_, *bound_, dead_ends_ ? &*dead_ends_ : nullptr);
  return true;
}

void OptimalSearch::forget() {
  sat_.reset();
  guided_.reset();
  nearness_.reset();
  bound_.reset();
  dead_ends_.reset();
  exclusions_.reset();
  prepared_ = false;
}

Outcome OptimalSearch::run(const Budget& budget, const std::function<bool()>& caller_cancelled) {
  if (problem_.goals.subset_of(problem_.initials)) {
    return {.kind = Outcome::Kind::plan, .engine = "guided"};
  }
  bool stopped = false;  // for good: what was given up half-way must not be used
  const std::function<bool()> cancelled = [&] { return stopped = stopped || caller_cancelled(); };
  const auto gone = [&] {
    forget();
    return Outcome{.kind = Outcome::Kind::cancelled};
  };
  if (!exclusions_ && table_bytes(problem_) > budget.bytes) return out_of_memory(budget);
  if (!exclusions_) exclusions_.emplace(problem_, cancelled);
  if (stopped) return gone();
  std::vector<std::size_t> excluded = excluded_goals(problem_.goals, *exclusions_);
  if (!excluded.empty()) return none_because(std::move(excluded));
  if (!prepare(cancelled)) return gone();
  if (!dead_ends_ || !dead_ends_->contain(problem_.initials)) return attempt(budget, cancelled);
  return none_because(problem_.goals.members());
}

// One search after another, while budget is left.
Outcome OptimalSearch::attempt(const Budget& budget, const std::function<bool()>& cancelled) {
  Outcome outcome;
  std::size_t nodes = 0;
  std::size_t at_least = 1;
  const auto ended = [&](std::string_view engine) {
    nodes += outcome.nodes;
    outcome.nodes = nodes;
    outcome.engine = engine;
    return outcome.kind != Outcome::Kind::gave_up || nodes >= budget.nodes;
  };
  if (guided_) {
    at_least = std::max(at_least, bound_->from(problem_.initials).value_or(0));
    outcome = guided_->run(part(budget, guided_nodes, nodes), cancelled);
    if (ended("guided")) return outcome;
  }
  outcome = StepSearch().solve(problem_, part(budget, stepwise_nodes, nodes), cancelled);
  if (ended("stepwise") || PlanningGraph::base_bytes(problem_) > budget.bytes) return outcome;
  if (!sat_) sat_.emplace(problem_, *exclusions_);
  outcome = sat_->run(at_least, part(budget, budget.nodes, nodes), cancelled);
  ended("sat");
  return outcome;
}

}  // namespace pizarra::planner
