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

Outcome ended(Outcome::Kind kind, std::size_t nodes) {
  return {.kind = kind, .steps = {}, .culprits = {}, .spent = {}, .nodes = nodes};
}

}  // namespace

Outcome BreadthFirst::solve(const Problem& problem, const Budget& budget, const std::function<bool()>& cancelled) {
  std::vector<Reached> reached{{problem.initials, 0, 0}};
  std::unordered_set<Bits, HashBits> seen{problem.initials};
  const std::size_t bytes_a_state = 2 * problem.initials.words().size() * 8 + 128;
  for (std::size_t index = 0; index < reached.size(); ++index) {
    if (problem.goals.subset_of(reached[index].state)) {
      Outcome outcome = ended(Outcome::Kind::plan, reached.size());
      outcome.steps = steps_to(reached, index);
      return outcome;
    }
    if (index % 256 == 0 && cancelled()) return ended(Outcome::Kind::cancelled, reached.size());
    if (reached.size() > budget.nodes || reached.size() * bytes_a_state > budget.bytes) {
      Outcome outcome = ended(Outcome::Kind::gave_up, reached.size());
      outcome.spent = fmt::format("{} states", reached.size());
      return outcome;
    }
    for (std::size_t i = 0; i < problem.actions.size(); ++i) {
      const GroundAction& action = problem.actions[i];
      const Bits& state = reached[index].state;
      if (!applicable(action, state)) continue;
      Bits next = after(state, action);
      if (seen.insert(next).second) reached.push_back({std::move(next), index, i});
    }
  }
  Outcome outcome = ended(Outcome::Kind::none, reached.size());
  problem.goals.for_each([&](std::size_t goal) { outcome.culprits.push_back(goal); });
  return outcome;
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
