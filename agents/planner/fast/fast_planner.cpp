#include "agents/planner/fast/fast_planner.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <new>

#include "agents/planner/distance/compact_problem.hpp"
#include "agents/planner/distance/impossible_goals.hpp"
#include "agents/planner/fast/beam_search.hpp"
#include "agents/planner/fast/greedy_search.hpp"
#include "agents/planner/fast/hill_climbing.hpp"
#include "agents/planner/fast/plan_reordering.hpp"
#include "agents/planner/fast/proved_shortest.hpp"
#include "agents/planner/task/idle_actions.hpp"

namespace pizarra::planner {

namespace {

// States of the greedy search in vain, before the climb has its turn; with a hundred blocks it recovers from 80.
constexpr std::size_t greedy_patience = 200;

// Of reordering. The first cost a tenth of the proof that is tried next and may take longer than there is time, and at
// most a quarter of the budget; the others come before a beam has its turn, and the longer the plan, the more ways
// there are.
constexpr std::size_t first_attempts_an_action = 5;
constexpr std::size_t vain_attempts = 1000;
constexpr std::size_t vain_attempts_an_action = 60;

bool comes_after(const GroundAction& later, const GroundAction& earlier) {
  const auto needed = [&](std::size_t fact) { return std::ranges::binary_search(later.preconditions, fact); };
  return std::ranges::any_of(earlier.adds, needed) || interfere(later, earlier);
}

// Every action in the first step that its order with those before it allows.
std::vector<std::vector<std::size_t>> in_parallel(const Problem& problem, const std::vector<ActionIndex>& plan) {
  std::vector<std::vector<std::size_t>> steps;
  for (const ActionIndex index : plan) {
    std::size_t step = steps.size();
    const GroundAction& action = problem.actions[index];
    const auto free_of = [&](const std::vector<std::size_t>& others) {
      return std::ranges::none_of(others,
                                  [&](std::size_t other) { return comes_after(action, problem.actions[other]); });
    };
    while (step > 0 && free_of(steps[step - 1])) --step;
    if (step == steps.size()) steps.emplace_back();
    steps[step].push_back(index);
  }
  for (std::vector<std::size_t>& step : steps) std::ranges::sort(step);
  return steps;
}

Outcome ended(Outcome::Kind kind, std::size_t nodes) { return {.kind = kind, .nodes = nodes, .engine = "fast"}; }

Outcome without_plan(SearchEnd end, const Problem& problem, const SearchBudget& spent) {
  if (end == SearchEnd::cancelled) return ended(Outcome::Kind::cancelled, spent.nodes());
  Outcome outcome = ended(end == SearchEnd::spent ? Outcome::Kind::gave_up : Outcome::Kind::none, spent.nodes());
  if (end == SearchEnd::spent) outcome.spent = fmt::format("{} states", spent.nodes());
  if (end == SearchEnd::exhausted) outcome.culprits = problem.goals.members();
  return outcome;
}

std::vector<ActionIndex> lean(const Problem& problem, const std::vector<ActionIndex>& plan) {
  std::vector<std::vector<std::size_t>> steps;
  for (const ActionIndex action : plan) steps.push_back({action});
  std::vector<ActionIndex> needed;
  for (const std::vector<std::size_t>& step : without_idle_actions(problem, steps)) {
    needed.push_back(static_cast<ActionIndex>(step.front()));
  }
  return needed;
}

// The greedy search asks cheaply and knows blocks best; where it goes astray, the climb asks more, and may give up; the
// greedy search then goes on, and is the one to prove that there is no plan.
SearchEnd find_plan(Nearness& nearness, SearchBudget& spent, std::vector<ActionIndex>& plan) {
  GreedySearch greedy(nearness.compact, nearness.estimate, spent);
  std::optional<SearchEnd> end = greedy.run(greedy_patience);
  if (!end) {
    HillClimbing climbing(nearness.compact, spent);
    end = climbing.run();
    plan = climbing.plan();
    if (end != SearchEnd::exhausted) return *end;
    end = greedy.run();
  }
  plan = greedy.plan();
  return *end;
}

// The best plan so far, and the ways to a better one.
class Improvement {
 public:
  Improvement(const Problem& problem, Nearness& nearness, SearchBudget& spent, const FastPlannerOptions& options)
      : problem_(problem),
        nearness_(nearness),
        compact_(nearness.compact),
        spent_(spent),
        options_(options),
        random_(options.seed) {}

  void keep(const std::vector<ActionIndex>& plan) {
    // Where memory ends on the way, the plan before stays whole.
    std::vector<ActionIndex> better = lean(problem_, plan);
    best_.steps = in_parallel(problem_, better);
    plan_ = std::move(better);
    if (options_.better) options_.better(best_);
  }

  // Until the budget is spent, or many attempts were in vain.
  void reorder_only() {
    while (reorder(vain_attempts)) {
    }
  }

  // Until the budget is spent, or nothing is left to look at.
  void run() {
    reorder(first_attempts());
    if (spent_.stopped() || is_shortest() || spent_.stopped()) return;
    BeamSearch beam(compact_, nearness_.estimate, spent_, options_.seed);
    for (std::size_t width = 2; width <= widest() && !plan_.empty(); width *= 2) {
      while (reorder(vain_attempts + vain_attempts_an_action * plan_.size())) {
      }
      if (spent_.stopped()) return;
      const SearchEnd end = beam.run(width, plan_.size() - 1);
      if (end == SearchEnd::found) keep(beam.plan());
      if (end == SearchEnd::cancelled || end == SearchEnd::spent) return;
      if (end == SearchEnd::exhausted && beam.complete()) return;
    }
  }

  void note_out_of_memory() { best_.out_of_memory = true; }

  Outcome best() {
    best_.nodes = spent_.nodes();
    return best_;
  }

 private:
  bool is_shortest() {
    ProvedShortest shortest(problem_, nearness_, spent_);
    const std::optional<Outcome> shorter = shortest.shorter_than(plan_.size());
    if (shorter) {
      std::vector<ActionIndex> plan;
      for (const std::vector<std::size_t>& step : shorter->steps)
        plan.push_back(static_cast<ActionIndex>(step.front()));
      keep(plan);
    }
    if (shortest.lacked_memory()) note_out_of_memory();
    return best_.shortest = shortest.proved();
  }

  std::size_t first_attempts() const {
    const std::size_t actions = std::max<std::size_t>(1, plan_.size());
    return std::min(first_attempts_an_action * actions, spent_.nodes_left() / 4 / actions);
  }

  // Whether the plan became shorter.
  bool reorder(std::size_t attempts) {
    const std::size_t before = plan_.size();
    PlanReordering reordering(compact_, plan_, random_);
    for (std::size_t i = 0; i < attempts && !plan_.empty() && !spent_.stopped(); ++i) {
      spent_.count(plan_.size());
      if (!reordering.try_once()) continue;
      keep(reordering.plan());
      reordering.go_on_from(plan_);
    }
    return plan_.size() < before;
  }

  // How wide a beam the memory allows.
  std::size_t widest() const {
    const std::size_t bytes_a_state = 2 * compact_.initials().words().size() * 8 + 4096;
    return std::max<std::size_t>(1, spent_.bytes() / 2 / bytes_a_state);
  }

  const Problem& problem_;
  Nearness& nearness_;
  const CompactProblem& compact_;
  SearchBudget& spent_;
  const FastPlannerOptions& options_;
  Random random_;
  std::vector<ActionIndex> plan_;
  Outcome best_ = ended(Outcome::Kind::plan, 0);
};

}  // namespace

Outcome FastPlanner::solve(const Problem& problem, const Budget& budget,
                           const std::function<bool()>& caller_cancelled) {
  bool stopped = false;  // for good: what was given up half-way must not be used
  const std::function<bool()> cancelled = [&] { return stopped = stopped || caller_cancelled(); };
  Nearness nearness(problem, cancelled);
  if (stopped) return ended(Outcome::Kind::cancelled, 0);
  return solve(problem, nearness, budget, cancelled);
}

Outcome FastPlanner::shorten(const Problem& problem, Nearness& nearness, const std::vector<ActionIndex>& plan,
                             const Budget& budget, const std::function<bool()>& cancelled) {
  SearchBudget spent(budget, cancelled);
  Improvement improvement(problem, nearness, spent, options_);
  improvement.keep(plan);
  improvement.reorder_only();
  return improvement.best();
}

Outcome FastPlanner::solve(const Problem& problem, Nearness& nearness, const Budget& budget,
                           const std::function<bool()>& cancelled) {
  if (std::vector<std::size_t> never = impossible_goals(nearness.compact, nearness.invariants); !never.empty()) {
    Outcome none = ended(Outcome::Kind::none, 0);
    none.culprits = std::move(never);
    return none;
  }
  SearchBudget spent(budget, cancelled);
  Improvement improvement(problem, nearness, spent, options_);
  std::vector<ActionIndex> plan;
  const SearchEnd end = find_plan(nearness, spent, plan);
  if (end != SearchEnd::found) return without_plan(end, problem, spent);
  improvement.keep(plan);
  if (options_.first_only) return improvement.best();
  try {
    improvement.run();
  } catch (const std::bad_alloc&) {
    improvement.note_out_of_memory();
  }
  return improvement.best();
}

}  // namespace pizarra::planner
