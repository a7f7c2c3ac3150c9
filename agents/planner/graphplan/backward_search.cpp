#include "agents/planner/graphplan/backward_search.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace pizarra::planner {

namespace {

// Every choice is one stack frame of about half a kilobyte; a worker thread has 8 MB.
constexpr std::size_t max_depth = 6000;
constexpr std::size_t nodes_between_looks = 1024;

}  // namespace

BackwardSearch::BackwardSearch(const Problem& problem, const PlanningGraph& graph, const Budget& budget,
                               const std::function<bool()>& cancelled)
    : problem_(problem), graph_(graph), budget_(budget), is_cancelled_(cancelled) {}

Bits BackwardSearch::bits_of(const Nogoods::Entry& nogood) const {
  Bits bits(problem_.facts.size());
  for (const std::size_t fact : nogood.facts) bits.set(fact);
  return bits;
}

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
  return solve(goals, level, conflict);
}

// True when the goals can be reached; else `conflict` holds those of them that cannot be reached together.
bool BackwardSearch::solve(const Bits& goals, std::size_t level, Bits& conflict) {
  if (level == 0) return true;
  const std::optional<std::size_t> known = nogoods_.find(goals, level);
  if (known) {
    conflict = bits_of(nogoods_.entries()[*known]);
    return false;
  }
  if (support(goals, level, nullptr, conflict)) return true;
  if (stopped()) return false;
  shrink(conflict, level);
  nogoods_.add(conflict.members(), level);
  return false;
}

// Leaves out of the conflict what is not needed for it, as far as one step back shows.
void BackwardSearch::shrink(Bits& conflict, std::size_t level) {
  if (level == 1) return;
  const Horizon horizon{nogoods_, level - 1};
  Bits smaller(problem_.facts.size());
  for (const std::size_t fact : conflict.members()) {
    if (!conflict.test(fact)) continue;
    Bits without = conflict;
    without.reset(fact);
    if (!support(without, level, &horizon, smaller) && !stopped()) conflict = smaller;
  }
}

// Whether actions of the level support the goals and can be taken themselves; with a horizon: as far as that says.
bool BackwardSearch::support(const Bits& goals, std::size_t level, const Horizon* horizon, Bits& conflict) {
  Level here{.index = level, .goals = goals, .actions = graph_.action_level(level), .horizon = horizon};
  // Whatever deletes a goal excludes all that could support it.
  Bits excluded(graph_.action_count());
  goals.for_each([&](std::size_t goal) { excluded |= graph_.deleters(goal); });
  return choose(here, goals, excluded, conflict);
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
  std::vector<std::size_t> order = candidates.members();
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
  if (level.horizon != nullptr) {
    const Nogoods& nogoods = level.horizon->nogoods;
    const std::optional<std::size_t> known = nogoods.find(needed, level.horizon->level);
    if (!known) return true;
    below = bits_of(nogoods.entries()[*known]);
  } else if (solve(needed, level.index - 1, below)) {
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

// Raises all nogoods proved for just `level` steps that hold for one more; whether none is left.
bool BackwardSearch::push_all(std::size_t level) {
  bool all = true;
  const Horizon horizon{nogoods_, level};
  Bits conflict(problem_.facts.size());
  for (std::size_t i = 0; i < nogoods_.entries().size() && !stopped(); ++i) {
    if (nogoods_.entries()[i].level != level) continue;
    const Bits facts = bits_of(nogoods_.entries()[i]);
    if (nogoods_.find(facts, level + 1)) continue;
    if (support(facts, level + 1, &horizon, conflict)) {
      all = false;
    } else if (!stopped()) {
      nogoods_.add(conflict.members(), level + 1);
    }
  }
  return all;
}

// The nogoods proved for `level` steps, without those that lead to something else one step back.
Nogoods BackwardSearch::inductive(std::size_t level) {
  std::vector<std::vector<std::size_t>> family;
  for (const Nogoods::Entry& entry : nogoods_.entries()) {
    if (entry.level >= level) family.push_back(entry.facts);
  }
  while (true) {
    Nogoods nogoods;
    for (const std::vector<std::size_t>& facts : family) nogoods.add(facts, 1);
    const Horizon horizon{nogoods, 1};
    Bits conflict(problem_.facts.size());
    const std::size_t dropped = std::erase_if(family, [&](const std::vector<std::size_t>& facts) {
      return support(bits_of({.facts = facts}), level, &horizon, conflict) || stopped();
    });
    if (dropped == 0) return nogoods;
  }
}

std::optional<std::vector<std::size_t>> BackwardSearch::excluded_for_ever(const Bits& goals, std::size_t level) {
  const std::size_t levelled_off = *graph_.levelled_off();
  for (std::size_t below = levelled_off; below < level && !stopped(); ++below) {
    if (!push_all(below)) continue;
    // Nothing was learned between two levels, so what is proved for the higher may prove itself. If it does not, less,
    // further up, does not either.
    const Nogoods nogoods = inductive(below + 1);
    const std::optional<std::size_t> found = nogoods.find(goals, 1);
    if (!found || stopped()) return std::nullopt;
    return nogoods.entries()[*found].facts;
  }
  return std::nullopt;
}

}  // namespace pizarra::planner
