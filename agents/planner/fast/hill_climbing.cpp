#include "agents/planner/fast/hill_climbing.hpp"

#include <algorithm>

namespace pizarra::planner {

namespace {

// Looked at in vain around one state. Every climb shortens the distance, so that this bounds the whole.
constexpr std::size_t most_states_around = 2000;

}  // namespace

SearchEnd HillClimbing::run() {
  spent_.count();
  if (!relaxed_.look_at(problem_.initials())) return SearchEnd::exhausted;
  distance_ = relaxed_.length();
  queue_.push_back({problem_.initials(), 0, 0, relaxed_.helpful()});
  while (distance_ > 0) {
    const SearchEnd end = climb();
    if (end != SearchEnd::found) return end;
  }
  return SearchEnd::found;
}

// Breadth first from the queue's only state to the first one that is nearer.
SearchEnd HillClimbing::climb() {
  states_ = {queue_.front().state};
  for (std::uint32_t from = 0; from < queue_.size() && states_.size() <= most_states_around; ++from) {
    if (const auto stopped = spent_.stopped()) return *stopped;
    for (std::size_t i = 0; i < queue_[from].helpful.size(); ++i) {
      if (visit(from, queue_[from].helpful[i])) return SearchEnd::found;
    }
  }
  return SearchEnd::exhausted;
}

bool HillClimbing::visit(std::uint32_t from, ActionIndex action) {
  Bits state = queue_[from].state;
  problem_.apply(action, state);
  if (!states_.insert(state).second) return false;
  spent_.count();
  if (!relaxed_.look_at(state)) return false;
  queue_.push_back({std::move(state), from, action, relaxed_.helpful()});
  if (relaxed_.length() >= distance_) return false;
  distance_ = relaxed_.length();
  const auto way = static_cast<std::ptrdiff_t>(plan_.size());
  for (auto i = static_cast<std::uint32_t>(queue_.size() - 1); i != 0; i = queue_[i].from)
    plan_.push_back(queue_[i].action);
  std::reverse(plan_.begin() + way, plan_.end());
  queue_.front() = std::move(queue_.back());
  queue_.resize(1);
  return true;
}

}  // namespace pizarra::planner
