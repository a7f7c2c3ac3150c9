#include "agents/planner/reach/relaxed_reach.hpp"

namespace pizarra::planner {

RelaxedReach::RelaxedReach(const Problem& problem, const Bits& allowed)
    : problem_(problem), need_count_(problem.actions.size()) {
  Rows needs;
  const std::vector<std::size_t> nothing;
  for (std::size_t action = 0; action < problem.actions.size(); ++action) {
    const std::vector<std::size_t>& preconditions = problem.actions[action].preconditions;
    adds_.add(problem.actions[action].adds);
    needs.add(allowed.test(action) ? preconditions : nothing);
    need_count_[action] = static_cast<std::uint32_t>(preconditions.size());
    if (allowed.test(action) && preconditions.empty()) needless_.push_back(action);
  }
  needed_by_ = transposed(needs, problem.facts.size());
}

void RelaxedReach::take(std::size_t action, const Bits& forbidden) {
  if (forbidden.test(action)) return;
  actions_.set(action);
  for (const std::uint32_t fact : adds_[action]) {
    if (facts_.test(fact)) continue;
    facts_.set(fact);
    open_.push_back(fact);
  }
}

void RelaxedReach::from(const Bits& state, const Bits& forbidden) {
  missing_ = need_count_;
  facts_ = state;
  actions_ = Bits(problem_.actions.size());
  open_.clear();
  state.for_each([&](std::size_t fact) { open_.push_back(fact); });
  for (const std::size_t action : needless_) take(action, forbidden);
  while (!open_.empty()) {
    const std::size_t fact = open_.back();
    open_.pop_back();
    for (const std::uint32_t action : needed_by_[fact]) {
      if (--missing_[action] == 0) take(action, forbidden);
    }
  }
}

}  // namespace pizarra::planner
