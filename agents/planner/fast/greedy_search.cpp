#include "agents/planner/fast/greedy_search.hpp"

#include <algorithm>

namespace pizarra::planner {

std::optional<SearchEnd> GreedySearch::run(std::size_t patience) {
  if (reached_.empty()) reached_.push_back({&*states_.insert(problem_.initials()).first, 0, 0});
  const std::size_t bytes_a_state = problem_.initials().words().size() * 8 + 100;
  for (std::size_t in_vain = 0; in_vain <= patience; ++in_vain) {
    const auto newest = static_cast<std::uint32_t>(reached_.size() - 1);
    if (problem_.goals().subset_of(*reached_[newest].state)) {
      for (std::uint32_t i = newest; i != 0; i = reached_[i].from) plan_.push_back(reached_[i].action);
      std::ranges::reverse(plan_);
      return SearchEnd::found;
    }
    expand(newest);
    if (const auto stopped = spent_.stopped()) return *stopped;
    if (reached_.size() * bytes_a_state + candidates_.size() * sizeof(Candidate) > spent_.bytes()) {
      return SearchEnd::spent;
    }
    const Distance before = nearest_;
    if (!reach_nearest()) return SearchEnd::exhausted;
    if (nearest_ < before) in_vain = 0;
  }
  return std::nullopt;
}

void GreedySearch::expand(std::uint32_t index) {
  const Bits& state = *reached_[index].state;
  estimate_.look_at(state);
  problem_.for_each_applicable(state, [&](ActionIndex action) {
    spent_.count();
    const std::optional<Distance> distance = estimate_.beyond(action);
    if (distance) candidates_.push({*distance, serial_++, index, action});
  });
}

bool GreedySearch::reach_nearest() {
  while (!candidates_.empty()) {
    const Candidate candidate = candidates_.top();
    candidates_.pop();
    if (!reach(candidate)) continue;
    nearest_ = std::min(nearest_, candidate.distance);
    return true;
  }
  return false;
}

bool GreedySearch::reach(const Candidate& candidate) {
  Bits state = *reached_[candidate.from].state;
  problem_.apply(candidate.action, state);
  const auto [at, added] = states_.insert(std::move(state));
  if (added) reached_.push_back({&*at, candidate.from, candidate.action});
  return added;
}

}  // namespace pizarra::planner
