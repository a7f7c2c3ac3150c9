#include "agents/planner/optimal_planner.hpp"

#include <algorithm>

#include "agents/planner/guided_search.hpp"
#include "agents/planner/sat_search.hpp"
#include "agents/planner/step_search.hpp"

namespace pizarra {

namespace {

// Beyond this many nodes satisfiability has better prospects.
constexpr std::size_t guided_nodes = 20'000;
constexpr std::size_t stepwise_nodes = 100'000;
// Of resources for a bound, those that the most facts speak of are looked at.
constexpr std::size_t max_resources = 8;

using Culprits = std::vector<std::size_t>;

Outcome none_because(Culprits culprits) {
  return {.kind = Outcome::Kind::none, .steps = {}, .culprits = std::move(culprits), .spent = {}, .nodes = 0};
}

// A goal that can never hold, or two that never hold together.
Culprits excluded_goals(const Bits& goals, const Exclusions& exclusions) {
  Culprits missing, pair;
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

// The facts of which every action takes one away, if there are such.
std::optional<FactGroup> resource_of_all(const Problem& problem, const Exclusions& exclusions) {
  for (FactGroup& group : exclusion_groups(exclusions)) {
    bool all = true;
    exclusions.actions().for_each([&](std::size_t i) {
      const GroundAction& action = problem.actions[i];
      all = all && std::ranges::any_of(action.deletes, [&](std::size_t fact) {
              return std::ranges::binary_search(group, fact) && std::ranges::binary_search(action.preconditions, fact);
            });
    });
    if (all) return std::move(group);
  }
  return std::nullopt;
}

// One attempt after another, while budget is left.
class Attempts {
 public:
  Attempts(const Problem& problem, const Exclusions& exclusions, const Budget& budget,
           const std::function<bool()>& cancelled)
      : problem_(problem), exclusions_(exclusions), budget_(budget), cancelled_(cancelled) {}

  Outcome run() {
    if (problem_.goals.subset_of(problem_.initials))
      return named("stepwise", {.kind = Outcome::Kind::plan, .steps = {}, .culprits = {}, .spent = {}, .nodes = 0});
    Culprits excluded = excluded_goals(problem_.goals, exclusions_);
    if (!excluded.empty()) return named("exclusions", none_because(std::move(excluded)));
    const DeadEnds dead_ends(problem_, exclusions_);
    if (dead_ends.contain(problem_.initials)) return named("exclusions", none_because(all_goals()));

    std::size_t at_least = 1;
    Outcome outcome;
    const std::optional<FactGroup> resource = resource_of_all(problem_, exclusions_);
    if (resource) {
      LandmarkBound bound(problem_, exclusions_, *resource);
      at_least = std::max(at_least, bound.from(problem_.initials).value_or(0));
      const Budget share = part(guided_nodes);
      outcome = GuidedSearch(problem_, exclusions_, dead_ends, bound, share, cancelled_).run();
      if (ended(outcome)) return named("guided", std::move(outcome));
    }
    outcome = StepSearch().solve(problem_, part(stepwise_nodes), cancelled_);
    if (ended(outcome)) return named("stepwise", std::move(outcome));
    if (PlanningGraph::base_bytes(problem_) > budget_.bytes) return named("stepwise", std::move(outcome));
    const Budget rest = part(budget_.nodes);
    return named("sat", SatSearch(problem_, exclusions_, rest, cancelled_).run(at_least));
  }

 private:
  Culprits all_goals() const {
    Culprits goals;
    problem_.goals.for_each([&](std::size_t goal) { goals.push_back(goal); });
    return goals;
  }
  Budget part(std::size_t nodes) const {
    Budget budget = budget_;
    budget.nodes = std::min(nodes, budget_.nodes - std::min(nodes_, budget_.nodes));
    return budget;
  }
  bool ended(const Outcome& outcome) {
    nodes_ += outcome.nodes;
    return outcome.kind != Outcome::Kind::gave_up || nodes_ >= budget_.nodes;
  }
  Outcome named(std::string_view engine, Outcome outcome) const {
    outcome.engine = engine;
    outcome.nodes = std::max(nodes_, outcome.nodes);
    return outcome;
  }

  const Problem& problem_;
  const Exclusions& exclusions_;
  const Budget& budget_;
  const std::function<bool()>& cancelled_;
  std::size_t nodes_ = 0;
};

// The culprits without those that the rest cannot be reached without anyway.
Culprits fewest_culprits(const Problem& problem, const Exclusions& exclusions, Culprits culprits, const Budget& budget,
                         const std::function<bool()>& cancelled) {
  Problem fewer = problem;
  const auto impossible = [&](const Culprits& goals) {
    fewer.goals.clear();
    for (const std::size_t goal : goals) fewer.goals.set(goal);
    return Attempts(fewer, exclusions, budget, cancelled).run().kind == Outcome::Kind::none;
  };
  for (std::size_t i = 0; i < culprits.size() && culprits.size() > 1;) {
    Culprits without = culprits;
    without.erase(without.begin() + static_cast<std::ptrdiff_t>(i));
    if (impossible(without)) {
      culprits = std::move(without);
    } else {
      ++i;
    }
  }
  return culprits;
}

}  // namespace

Outcome OptimalPlanner::solve(const Problem& problem, const Budget& budget, const std::function<bool()>& cancelled) {
  const Exclusions exclusions(problem);
  Outcome outcome = Attempts(problem, exclusions, budget, cancelled).run();
  if (outcome.kind != Outcome::Kind::none || outcome.culprits.size() < 2) return outcome;
  outcome.culprits = fewest_culprits(problem, exclusions, std::move(outcome.culprits), budget, cancelled);
  return outcome;
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
