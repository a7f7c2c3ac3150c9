#include "agents/planner/judge/breadth_first.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <unordered_set>

#include "agents/planner/task/grounding.hpp"

namespace pizarra::planner {

namespace {

struct Reached {
  Bits state;
  std::size_t from;
  std::size_t action;
};

std::vector<std::vector<std::size_t>> steps_to(const std::vector<Reached>& reached, std::size_t index) {
  std::vector<std::vector<std::size_t>> steps;
  for (; index != 0; index = reached[index].from) steps.push_back({reached[index].action});
  std::ranges::reverse(steps);
  return steps;
}

}  // namespace

Outcome BreadthFirst::solve(const Problem& problem, const Budget& budget, const std::function<bool()>& cancelled) {
  std::vector<Reached> reached{{problem.initials, 0, 0}};
  std::unordered_set<Bits, HashBits> seen{problem.initials};
  const std::size_t bytes_a_state = 2 * problem.initials.words().size() * 8 + 128;
  for (std::size_t index = 0; index < reached.size(); ++index) {
    if (problem.goals.subset_of(reached[index].state)) {
      return {.kind = Outcome::Kind::plan, .steps = steps_to(reached, index), .nodes = reached.size()};
    }
    if (index % 256 == 0 && cancelled()) return {.kind = Outcome::Kind::cancelled, .nodes = reached.size()};
    if (reached.size() > budget.nodes || reached.size() * bytes_a_state > budget.bytes) {
      return {.spent = fmt::format("{} states", reached.size()), .nodes = reached.size()};
    }
    for (std::size_t i = 0; i < problem.actions.size(); ++i) {
      const GroundAction& action = problem.actions[i];
      const Bits& state = reached[index].state;
      if (!applicable(action, state)) continue;
      Bits next = after(state, action);
      if (seen.insert(next).second) reached.push_back({std::move(next), index, i});
    }
  }
  return {.kind = Outcome::Kind::none, .culprits = problem.goals.members(), .nodes = reached.size()};
}

Result<bool> any_plan(const PlanningTask& task, const Budget& budget) {
  const Result<Problem> problem = ground(task);
  if (!problem) return fail(problem);
  const Outcome outcome = BreadthFirst().solve(*problem, budget, [] { return false; });
  if (outcome.kind == Outcome::Kind::plan) return true;
  if (outcome.kind == Outcome::Kind::none) return false;
  return fail("gave-up", fmt::format("no plan was found among {}, and there are more", outcome.spent));
}

}  // namespace pizarra::planner
