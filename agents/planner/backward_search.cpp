#include "agents/planner/backward_search.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace pizarra {

namespace {

// Every choice is one stack frame of about half a kilobyte; a worker thread has 8 MB.
constexpr std::size_t max_depth = 6000;
constexpr std::size_t nodes_between_looks = 1024;

}  // namespace

BackwardSearch::BackwardSearch(const Problem& problem, const PlanningGraph& graph, const Budget& budget,
                               const std::function<bool()>& cancelled)
    : problem_(problem), graph_(graph), budget_(budget), is_cancelled_(cancelled) {}

void BackwardSearch::count_node() {
  ++nodes_;
  if (nodes_ > budget_.nodes) spent_ = fmt::format("{} search nodes", budget_.nodes);
  if (depth_ > max_depth) spent_ = fmt::format("a search {} choices deep", max_depth);
  if (nodes_ % nodes_between_looks != 0) return;
  if (is_cancelled_()) cancelled_seen_ = true;
  if (graph_.bytes() + nogoods_.bytes() > budget_.bytes) spent_ = fmt::format("{} MB of memory", budget_.bytes >> 20);
}

bool BackwardSearch::reach(const Bits& goals, std::size_t level) {
  steps_.assign(level, {});
  Bits conflict(problem_.facts.size());
  return solve(goals, level, false, conflict);
}

// True when the goals can be reached (with one_step: when the nogoods do not say otherwise); else `conflict` holds
// those of the goals that cannot be reached together.
bool BackwardSearch::solve(const Bits& goals, std::size_t level, bool one_step, Bits& conflict) {
  if (level == 0) return true;
  conflict.clear();
  const std::optional<std::size_t> known = nogoods_.find(goals, level);
  if (known) {
    for (const std::size_t fact : nogoods_.entries()[*known].facts) conflict.set(fact);
    return false;
  }
  Level here{.index = level, .goals = goals, .actions = graph_.action_level(level), .one_step = one_step};
  // Whatever deletes a goal excludes all that could support it.
  Bits excluded(graph_.action_count());
  goals.for_each([&](std::size_t goal) { excluded |= graph_.deleters(goal); });
  if (choose(here, goals, excluded, conflict)) return true;
  if (stopped()) return false;
  std::vector<std::size_t> facts;
  conflict.for_each([&](std::size_t fact) { facts.push_back(fact); });
  nogoods_.add(std::move(facts), level);
  return false;
}

// The open goal with the fewest actions left for it.
std::size_t BackwardSearch::hardest(const Level& level, const Bits& open, const Bits& excluded) const {
  std::size_t best = 0;
  std::size_t fewest = SIZE_MAX;
  open.for_each([&](std::size_t goal) {
    if (fewest == 0) return;
    Bits candidates = graph_.supporters(goal);
    candidates &= level.actions.present;
    candidates -= excluded;
    const std::size_t count = candidates.count();
    if (count >= fewest) return;
    fewest = count;
    best = goal;
  });
  return best;
}

bool BackwardSearch::choose(Level& level, const Bits& open, const Bits& excluded, Bits& conflict) {
  count_node();
  if (stopped()) return false;
  if (!open.any()) return descend(level, conflict);
  const std::size_t goal = hardest(level, open, excluded);
  conflict.clear();
  conflict.set(goal);
  Bits candidates = graph_.supporters(goal);
  candidates &= level.actions.present;
  candidates -= excluded;
  std::vector<std::size_t> order;
  candidates.for_each([&](std::size_t action) { order.push_back(action); });
  // To keep what holds adds nothing to the plan; of the others those of the domain's first operators are preferred.
  std::ranges::stable_partition(order, [&](std::size_t action) { return graph_.keeps(action); });

  Bits below(problem_.facts.size());
  for (const std::size_t action : order) {
    Bits still_open = open;
    still_open -= graph_.adds(action);
    Bits now_excluded = excluded;
    now_excluded |= level.actions.mutex[action];
    level.choices.push_back({action, goal});
    ++depth_;
    const bool found = choose(level, still_open, now_excluded, below);
    --depth_;
    level.choices.pop_back();
    if (found) return true;
    if (stopped()) return false;
    if (!below.test(goal)) {
      // Whatever is chosen for this goal, the failure stays.
      conflict = below;
      return false;
    }
    conflict |= below;
  }
  blame_exclusions(level, goal, excluded, conflict);
  return false;
}

// Adds to the conflict, for every action that could have supported the goal, one goal for whose sake it is excluded.
void BackwardSearch::blame_exclusions(const Level& level, std::size_t goal, const Bits& excluded,
                                      Bits& conflict) const {
  Bits lost = graph_.supporters(goal);
  lost &= level.actions.present;
  lost &= excluded;
  lost.for_each([&](std::size_t action) {
    if (!graph_.keeps(action)) {
      const std::vector<std::size_t>& deletes = problem_.actions[action].deletes;
      if (std::ranges::any_of(deletes, [&](std::size_t fact) { return conflict.test(fact); })) return;
      const auto deleted = std::ranges::find_if(deletes, [&](std::size_t fact) { return level.goals.test(fact); });
      if (deleted != deletes.end()) return conflict.set(*deleted);
    }
    const auto excludes = [&](const Choice& choice) { return level.actions.mutex[choice.action].test(action); };
    const auto blamed = [&](const Choice& choice) { return conflict.test(choice.goal) && excludes(choice); };
    if (std::ranges::any_of(level.choices, blamed)) return;
    const auto first = std::ranges::find_if(level.choices, excludes);
    assert(first != level.choices.end());
    conflict.set(first->goal);
  });
}

// Every goal of the level is supported: on to what the chosen actions need.
bool BackwardSearch::descend(Level& level, Bits& conflict) {
  Bits needed(problem_.facts.size());
  for (const Choice& choice : level.choices) {
    for (const std::size_t fact : graph_.preconditions(choice.action)) needed.set(fact);
  }
  Bits below(problem_.facts.size());
  if (level.one_step) {
    const std::optional<std::size_t> known = level.index == 1 ? std::nullopt : nogoods_.find(needed, level.index - 1);
    if (!known) return true;
    for (const std::size_t fact : nogoods_.entries()[*known].facts) below.set(fact);
  } else if (solve(needed, level.index - 1, false, below)) {
    for (const Choice& choice : level.choices) {
      if (!graph_.keeps(choice.action)) steps_[level.index - 1].push_back(choice.action);
    }
    std::ranges::sort(steps_[level.index - 1]);
    return true;
  }
  if (stopped()) return false;
  conflict.clear();
  below.for_each([&](std::size_t fact) {
    const auto needs = [&](const Choice& choice) {
      const std::vector<std::size_t>& preconditions = graph_.preconditions(choice.action);
      return std::ranges::find(preconditions, fact) != preconditions.end();
    };
    const auto blamed = [&](const Choice& choice) { return conflict.test(choice.goal) && needs(choice); };
    if (std::ranges::any_of(level.choices, blamed)) return;
    conflict.set(std::ranges::find_if(level.choices, needs)->goal);
  });
  return false;
}

// Whether the nogood, proved for `level` steps, holds for one more.
bool BackwardSearch::push(std::size_t entry, std::size_t level) {
  Bits facts(problem_.facts.size());
  for (const std::size_t fact : nogoods_.entries()[entry].facts) facts.set(fact);
  Bits conflict(problem_.facts.size());
  return !solve(facts, level + 1, true, conflict) && !stopped();
}

std::optional<std::size_t> BackwardSearch::proved_for_ever(std::size_t levelled_off, std::size_t level) {
  for (std::size_t below = levelled_off; below < level; ++below) {
    bool all_pushed = true;
    for (std::size_t entry = 0; entry < nogoods_.entries().size() && !stopped(); ++entry) {
      if (nogoods_.entries()[entry].level != below) continue;
      if (!push(entry, below)) all_pushed = false;
    }
    if (stopped()) return std::nullopt;
    if (all_pushed) return below + 1;
  }
  return std::nullopt;
}

}  // namespace pizarra
