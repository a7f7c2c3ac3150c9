#include "agents/planner/fast/last_plan.hpp"

#include <algorithm>
#include <unordered_set>

namespace pizarra::planner {

namespace {

constexpr std::size_t most_states_on_the_way_back = 1000;

}  // namespace

LastPlan::LastPlan(const Problem& problem, Steps steps, PlanMode mode)
    : steps_(std::move(steps)),
      mode_(mode),
      states_{problem.initials},
      needed_(steps_.size() + 1, problem.goals),
      actions_left_(steps_.size() + 1) {
  for (const std::vector<std::size_t>& step : steps_) {
    Bits next = states_.back();
    for (const std::size_t action : step) apply(problem.actions[action], next);
    states_.push_back(std::move(next));
  }
  for (std::size_t i = steps_.size(); i-- > 0;) {
    needed_[i] = needed_[i + 1];
    actions_left_[i] = actions_left_[i + 1] + steps_[i].size();
    for (const std::size_t action : steps_[i]) {
      for (const std::size_t fact : problem.actions[action].adds) needed_[i].reset(fact);
    }
    for (const std::size_t action : steps_[i]) {
      for (const std::size_t fact : problem.actions[action].preconditions) needed_[i].set(fact);
    }
  }
}

std::optional<std::size_t> LastPlan::end_that_works(const Bits& state) const {
  for (std::size_t i = needed_.size(); i-- > 0;) {
    if (needed_[i].subset_of(state)) return i;
  }
  return std::nullopt;
}

std::optional<LastPlan::Steps> LastPlan::rest_from(const Bits& state) const {
  std::optional<std::size_t> begin;
  if (mode_ == PlanMode::fast) {
    begin = end_that_works(state);
  } else if (const auto here = std::ranges::find(states_, state); here != states_.end()) {
    begin = static_cast<std::size_t>(here - states_.begin());
  }
  if (!begin) return std::nullopt;
  return Steps(steps_.begin() + static_cast<std::ptrdiff_t>(*begin), steps_.end());
}

// Breadth-first; then the nearest way back is not always the one with the least left to do.
std::optional<std::vector<ActionIndex>> LastPlan::repaired(const CompactProblem& problem, const Bits& state) const {
  struct Reached {
    Bits state;
    std::size_t from = 0;
    ActionIndex action = 0;
    std::size_t actions = 0;
  };
  struct Way {
    std::size_t to, end, actions;
  };
  std::vector<Reached> reached{{.state = state}};
  std::unordered_set<Bits, HashBits> seen{state};  // looked up only
  std::optional<Way> best;
  for (std::size_t index = 0; index < reached.size(); ++index) {
    const Bits here = reached[index].state;
    const std::size_t actions = reached[index].actions;
    if (const std::optional<std::size_t> end = end_that_works(here)) {
      const Way way{index, *end, actions + actions_left_[*end]};
      if (!best || way.actions < best->actions) best = way;
    }
    problem.for_each_applicable(here, [&](ActionIndex action) {
      if (reached.size() >= most_states_on_the_way_back) return;
      Bits next = here;
      problem.apply(action, next);
      if (seen.insert(next).second) reached.push_back({std::move(next), index, action, actions + 1});
    });
  }
  if (!best) return std::nullopt;
  std::vector<ActionIndex> plan;
  for (std::size_t i = best->to; i != 0; i = reached[i].from) plan.push_back(reached[i].action);
  std::ranges::reverse(plan);
  for (std::size_t i = best->end; i < steps_.size(); ++i) plan.insert(plan.end(), steps_[i].begin(), steps_[i].end());
  return plan;
}

}  // namespace pizarra::planner
