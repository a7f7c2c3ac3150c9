#include "agents/planner/distance/relaxed_plan.hpp"

#include <algorithm>
#include <iterator>

namespace pizarra::planner {

namespace {

constexpr std::uint32_t never = ~std::uint32_t{0};

}  // namespace

RelaxedPlan::RelaxedPlan(const CompactProblem& problem) : problem_(problem) {
  for (ActionIndex action = 0; action < problem.actions(); ++action) {
    at_first_.push_back({static_cast<std::uint32_t>(problem.preconditions(action).size()), 0});
    if (at_first_.back().missing == 0) needless_.push_back(action);
  }
  problem.goals().for_each([&](std::size_t goal) { goals_.push_back(static_cast<FactIndex>(goal)); });
}

bool RelaxedPlan::look_at(const Bits& state) {
  if (!reach_goals(state)) return false;
  gather(state);
  return true;
}

bool RelaxedPlan::reach_goals(const Bits& state) {
  reached_.assign(problem_.facts(), {never, 0, 0, false});
  awaiting_ = at_first_;
  layer_.clear();
  next_layer_.clear();
  std::size_t goals_missing = goals_.size();
  state.for_each([&](std::size_t fact) {
    reached_[fact].layer = 0;
    layer_.push_back(static_cast<FactIndex>(fact));
  });
  for (const ActionIndex action : needless_) do_in_layer(0, action);
  for (std::uint32_t layer = 0; !layer_.empty(); ++layer) {
    for (const FactIndex fact : layer_) goals_missing -= problem_.goals().test(fact) ? 1 : 0;
    if (goals_missing == 0) return true;
    for (const FactIndex fact : layer_) {
      for (const ActionIndex action : problem_.needing(fact)) {
        awaiting_[action].difficulty += layer;
        if (--awaiting_[action].missing == 0) do_in_layer(layer, action);
      }
    }
    layer_.swap(next_layer_);
    next_layer_.clear();
  }
  return goals_missing == 0;
}

void RelaxedPlan::do_in_layer(std::uint32_t layer, ActionIndex action) {
  const std::uint32_t difficulty = awaiting_[action].difficulty;
  for (const FactIndex fact : problem_.adds(action)) {
    Reached& reached = reached_[fact];
    if (reached.layer == never) {
      next_layer_.push_back(fact);
    } else if (reached.layer != layer + 1 || reached.difficulty <= difficulty) {
      continue;
    }
    reached = {layer + 1, difficulty, action, false};
  }
}

void RelaxedPlan::need(FactIndex fact) {
  if (reached_[fact].layer == 0 || reached_[fact].needed) return;
  reached_[fact].needed = true;
  open_.push_back(fact);
}

// From the goals back to the state.
void RelaxedPlan::gather(const Bits& state) {
  planned_.assign(problem_.actions(), 0);
  length_ = 0;
  helpful_.clear();
  for (const FactIndex goal : goals_) need(goal);
  while (!open_.empty()) {
    const FactIndex fact = open_.back();
    open_.pop_back();
    const Reached& reached = reached_[fact];
    if (reached.layer == 1) {
      std::ranges::copy_if(problem_.adding(fact), std::back_inserter(helpful_),
                           [&](ActionIndex action) { return problem_.applicable(action, state); });
    }
    if (planned_[reached.by] != 0) continue;
    planned_[reached.by] = 1;
    ++length_;
    for (const FactIndex needed : problem_.preconditions(reached.by)) need(needed);
  }
  std::ranges::sort(helpful_);
  const auto twice = std::ranges::unique(helpful_);
  helpful_.erase(twice.begin(), twice.end());
}

}  // namespace pizarra::planner
