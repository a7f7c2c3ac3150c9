#include "agents/planner/fast/beam_search.hpp"

#include <algorithm>
#include <tuple>

#include "blackboard/time/random.hpp"

namespace pizarra::planner {

BeamSearch::BeamSearch(const CompactProblem& problem, LandmarkEstimate& estimate, SearchBudget& spent,
                       std::uint64_t seed)
    : problem_(problem), estimate_(estimate), spent_(spent), seed_(seed) {
  Random random(seed);
  for (std::size_t fact = 0; fact < problem.facts(); ++fact) keys_.push_back(random.bits());
}

SearchEnd BeamSearch::run(std::size_t width, std::size_t most_actions) {
  seen_.clear();
  steps_.assign(1, {0, 0});
  complete_ = true;
  layer_.clear();
  std::uint64_t hash = seed_;
  problem_.initials().for_each([&](std::size_t fact) { hash ^= keys_[fact]; });
  layer_.push_back({problem_.initials(), hash, 0});
  seen_.insert(hash);
  for (std::size_t actions = 0;; ++actions) {
    for (const Kept& kept : layer_) {
      if (!problem_.goals().subset_of(kept.state)) continue;
      take_plan(kept.step);
      return SearchEnd::found;
    }
    if (actions == most_actions || layer_.empty()) return SearchEnd::exhausted;
    candidates_.clear();
    for (std::uint32_t parent = 0; parent < layer_.size(); ++parent) {
      expand(parent);
      if (const auto stopped = spent_.stopped()) return *stopped;
    }
    keep_nearest(width);
  }
}

void BeamSearch::expand(std::uint32_t parent) {
  const Kept& kept = layer_[parent];
  estimate_.look_at(kept.state);
  problem_.for_each_applicable(kept.state, [&](ActionIndex action) {
    const std::uint64_t hash = hash_after(kept, action);
    if (seen_.contains(hash)) return;
    spent_.count();
    const std::optional<Distance> distance = estimate_.beyond(action);
    if (distance) candidates_.push_back({*distance, hash * 0x9e3779b97f4a7c15, hash, parent, action});
  });
}

std::uint64_t BeamSearch::hash_after(const Kept& kept, ActionIndex action) const {
  std::uint64_t hash = kept.hash;
  for (const FactIndex fact : problem_.deletes(action)) {
    if (kept.state.test(fact)) hash ^= keys_[fact];
  }
  for (const FactIndex fact : problem_.adds(action)) {
    if (!kept.state.test(fact)) hash ^= keys_[fact];
  }
  return hash;
}

void BeamSearch::keep_nearest(std::size_t width) {
  std::ranges::sort(candidates_, {}, [](const Candidate& candidate) {
    return std::tuple(candidate.distance, candidate.tie, candidate.parent, candidate.action);
  });
  next_layer_.clear();
  for (const Candidate& candidate : candidates_) {
    if (seen_.contains(candidate.hash)) continue;
    if (next_layer_.size() == width) {
      complete_ = false;
      break;
    }
    seen_.insert(candidate.hash);
    const Kept& parent = layer_[candidate.parent];
    next_layer_.push_back({parent.state, candidate.hash, static_cast<std::uint32_t>(steps_.size())});
    problem_.apply(candidate.action, next_layer_.back().state);
    steps_.push_back({parent.step, candidate.action});
  }
  layer_.swap(next_layer_);
}

void BeamSearch::take_plan(std::uint32_t step) {
  plan_.clear();
  for (; step != 0; step = steps_[step].from) plan_.push_back(steps_[step].action);
  std::ranges::reverse(plan_);
}

}  // namespace pizarra::planner
