#include "agents/planner/fast/plan_reordering.hpp"

#include <algorithm>

#include "agents/planner/fast/plan_shape.hpp"

namespace pizarra {

namespace {

constexpr std::size_t longest_piece = 8;

}  // namespace

PlanReordering::PlanReordering(const CompactProblem& problem, std::vector<ActionIndex> plan, Random& random)
    : problem_(problem), random_(random), plan_(std::move(plan)), adds_goal_(problem.actions()) {
  problem.goals().for_each([&](std::size_t goal) {
    for (const ActionIndex action : problem.adding(static_cast<FactIndex>(goal))) adds_goal_.set(action);
  });
}

bool PlanReordering::try_once() {
  if (plan_.size() < 2) return false;
  move_a_piece();
  if (!redo() || done_.size() > plan_.size()) return false;
  const bool shorter = done_.size() < plan_.size();
  plan_ = shorter ? without_idle_actions(problem_, done_) : done_;
  return shorter;
}

void PlanReordering::move_a_piece() {
  order_ = plan_;
  const std::size_t length = 1 + random_.below(std::min(longest_piece, plan_.size() - 1));
  const std::size_t from = random_.below(plan_.size() - length + 1);
  const std::size_t to = random_.below(plan_.size() - length + 1);
  const auto at = [&](std::size_t index) { return order_.begin() + static_cast<std::ptrdiff_t>(index); };
  begin_ = std::min(from, to);
  if (from < to) {
    std::rotate(at(from), at(from + length), at(to + length));
  } else {
    std::rotate(at(to), at(from), at(from + length));
  }
}

// Into done_; false where it gets stuck.
bool PlanReordering::redo() {
  const auto begin = order_.begin() + static_cast<std::ptrdiff_t>(begin_);
  done_.assign(order_.begin(), begin);
  order_.erase(order_.begin(), begin);
  Bits state = problem_.initials();
  for (const ActionIndex action : done_) problem_.apply(action, state);
  while (!problem_.goals().subset_of(state)) {
    const std::optional<ActionIndex> action = next(state);
    if (!action) return false;
    problem_.apply(*action, state);
    done_.push_back(*action);
  }
  return true;
}

// Takes it out of order_.
std::optional<ActionIndex> PlanReordering::next(const Bits& state) {
  auto first = order_.end();
  for (auto i = order_.begin(); i != order_.end(); ++i) {
    const bool needless = first != order_.end() && !adds_goal_.test(*i);
    if (needless || !problem_.applicable(*i, state)) continue;
    if (first == order_.end()) {
      first = i;
    } else if (makes_a_goal(*i, state) && suffices(i - order_.begin(), state)) {
      const ActionIndex action = *i;
      order_.swap(rest_);
      return action;
    }
  }
  if (first == order_.end()) return std::nullopt;
  const ActionIndex action = *first;
  order_.erase(first);
  return action;
}

bool PlanReordering::makes_a_goal(ActionIndex action, const Bits& state) const {
  return std::ranges::any_of(problem_.adds(action),
                             [&](FactIndex fact) { return problem_.goals().test(fact) && !state.test(fact); });
}

// Whether the goals are reached when the action is done now and then the others, as far as they can be; into rest_.
bool PlanReordering::suffices(std::ptrdiff_t index, Bits state) {
  problem_.apply(order_[static_cast<std::size_t>(index)], state);
  rest_.clear();
  for (std::size_t i = 0; i < order_.size(); ++i) {
    if (static_cast<std::ptrdiff_t>(i) == index || !problem_.applicable(order_[i], state)) continue;
    problem_.apply(order_[i], state);
    rest_.push_back(order_[i]);
  }
  return problem_.goals().subset_of(state);
}

}  // namespace pizarra
