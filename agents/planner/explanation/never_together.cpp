#include "agents/planner/explanation/never_together.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "agents/planner/explanation/fewest_culprits.hpp"
#include "agents/planner/optimal/optimal_search.hpp"
#include "agents/planner/task/notation.hpp"
#include "lisp/writer.hpp"

namespace pizarra::planner {

namespace {

// An explanation is not worth more work.
constexpr Budget budget{.nodes = 100'000, .bytes = 64 << 20};
constexpr std::size_t no_action = ~std::size_t{0};

// Of every fact the action that brings it about first if nothing is ever deleted.
std::vector<std::size_t> first_ways(const Problem& problem, const std::function<bool()>& cancelled) {
  std::vector<std::size_t> ways(problem.facts.size(), no_action);
  Bits reached = problem.initials;
  for (bool grows = true; grows && !cancelled();) {
    Bits next = reached;
    for (std::size_t i = 0; i < problem.actions.size(); ++i) {
      if (!applicable(problem.actions[i], reached)) continue;
      for (const std::size_t fact : problem.actions[i].adds) {
        if (next.test(fact)) continue;
        next.set(fact);
        ways[fact] = i;
      }
    }
    grows = !(next == reached);
    reached = std::move(next);
  }
  return ways;
}

// Of facts that never hold together as few as some work shows.
std::vector<std::size_t> fewest_conflict(const Problem& problem, const std::vector<std::size_t>& facts,
                                         const std::function<bool()>& cancelled) {
  Problem asked = problem;
  asked.goals.clear();
  for (const std::size_t fact : facts) asked.goals.set(fact);
  Outcome outcome = OptimalSearch(asked).run(budget, cancelled);
  if (outcome.kind != Outcome::Kind::none) return facts;
  blame_fewest(asked, budget, cancelled, outcome);
  return outcome.culprits;
}

bool is_only_way(const Problem& problem, std::size_t fact) {
  const auto adds_it = [&](const GroundAction& action) { return std::ranges::binary_search(action.adds, fact); };
  return std::ranges::count_if(problem.actions, adds_it) == 1;
}

std::string in_words(const PlanningTask& task, const Problem& problem, const std::vector<std::size_t>& facts) {
  std::string words;
  for (const std::size_t fact : facts) words += (words.empty() ? "" : " and ") + written(task, problem.facts[fact]);
  return words;
}

}  // namespace

std::vector<BlockedWay> why_never_together(const Problem& problem, std::size_t fact,
                                           const std::function<bool()>& cancelled) {
  const std::vector<std::size_t> ways = first_ways(problem, cancelled);
  std::vector<BlockedWay> blocked;
  for (std::size_t wanted = fact; ways[wanted] != no_action; wanted = blocked.back().conflict.front()) {
    const std::size_t action = ways[wanted];
    std::vector<std::size_t> conflict = fewest_conflict(problem, problem.actions[action].preconditions, cancelled);
    if (conflict.empty()) break;
    blocked.push_back({wanted, action, std::move(conflict), is_only_way(problem, wanted)});
    if (blocked.back().conflict.size() > 1) break;
  }
  return blocked;
}

std::string never_together_in_words(const PlanningTask& task, const Problem& problem, const Datum& fact,
                                    const std::function<bool()>& cancelled) {
  const auto number = std::ranges::find(problem.facts, fact) - problem.facts.begin();
  std::string text;
  const std::vector<BlockedWay> ways = why_never_together(problem, static_cast<std::size_t>(number), cancelled);
  for (const BlockedWay& way : ways) {
    const std::string wanted = written(task, problem.facts[way.fact]);
    const std::string conflict = in_words(task, problem, way.conflict);
    if (&way != &ways.back()) {
      text += fmt::format("{} needs {}, and ", wanted, conflict);
      continue;
    }
    text += fmt::format("{} needs {}, which never {}{}", write(problem.actions[way.action].name), conflict,
                        way.conflict.size() > 1 ? "hold together" : "holds",
                        way.only_way ? "" : ", and so it is with every other action that brings " + wanted + " about");
  }
  return text;
}

}  // namespace pizarra::planner
