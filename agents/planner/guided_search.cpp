#include "agents/planner/guided_search.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace pizarra {

namespace {

constexpr std::size_t no_way = SIZE_MAX;

}  // namespace

GuidedSearch::GuidedSearch(const Problem& problem, const Exclusions& exclusions, const DeadEnds& dead_ends,
                           LandmarkBound& bound, const Budget& budget, const std::function<bool()>& cancelled)
    : problem_(problem),
      exclusions_(exclusions),
      dead_ends_(dead_ends),
      bound_(bound),
      budget_(budget),
      cancelled_(cancelled) {}

Outcome GuidedSearch::ended(Outcome::Kind kind, std::string spent) const {
  return {.kind = kind, .steps = {}, .culprits = {}, .spent = std::move(spent), .nodes = nodes_};
}

void GuidedSearch::open(std::size_t index) {
  const std::size_t total = reached_[index].steps + reached_[index].at_least;
  if (open_.size() <= total) open_.resize(total + 1);
  open_[total].push_back(index);
}

void GuidedSearch::reach(Bits state, std::size_t from, std::size_t action, std::size_t steps) {
  const auto [known, is_new] = index_.emplace(state, reached_.size());
  if (!is_new) {
    Reached& old = reached_[known->second];
    if (old.steps <= steps) return;
    old.from = from;
    old.action = action;
    old.steps = steps;
    old.expanded = false;
    if (old.at_least != no_way) open(known->second);
    return;
  }
  ++nodes_;
  std::size_t at_least = dead_ends_.contain(state) ? no_way : bound_.from(state).value_or(no_way);
  // A step brings the goals nearer by one at most.
  if (!reached_.empty() && reached_[from].at_least > 0) at_least = std::max(at_least, reached_[from].at_least - 1);
  reached_.push_back({std::move(state), from, action, steps, at_least});
  if (at_least != no_way) open(reached_.size() - 1);
}

void GuidedSearch::expand(std::size_t index) {
  reached_[index].expanded = true;
  exclusions_.actions().for_each([&](std::size_t i) {
    const GroundAction& action = problem_.actions[i];
    const Bits& state = reached_[index].state;
    if (applicable(action, state)) reach(after(state, action), index, i, reached_[index].steps + 1);
  });
}

Outcome GuidedSearch::plan_to(std::size_t index) const {
  Outcome outcome = ended(Outcome::Kind::plan);
  for (; reached_[index].steps != 0; index = reached_[index].from) outcome.steps.push_back({reached_[index].action});
  std::ranges::reverse(outcome.steps);
  return outcome;
}

Outcome GuidedSearch::run() {
  const std::size_t bytes_a_state = 2 * problem_.initials.words().size() * 8 + 200;
  reach(problem_.initials, 0, 0, 0);
  for (std::size_t total = 0; total < open_.size(); ++total) {
    while (!open_[total].empty()) {
      const std::size_t index = open_[total].back();
      open_[total].pop_back();
      const Reached& here = reached_[index];
      if (here.expanded || here.steps + here.at_least != total) continue;
      if (problem_.goals.subset_of(here.state)) return plan_to(index);
      if (cancelled_()) return ended(Outcome::Kind::cancelled);
      if (nodes_ > budget_.nodes) return ended(Outcome::Kind::gave_up, fmt::format("{} states", nodes_));
      if (reached_.size() * bytes_a_state > budget_.bytes) {
        return ended(Outcome::Kind::gave_up, fmt::format("{} MB of memory", budget_.bytes >> 20));
      }
      expand(index);
    }
  }
  Outcome outcome = ended(Outcome::Kind::none);
  problem_.goals.for_each([&](std::size_t goal) { outcome.culprits.push_back(goal); });
  return outcome;
}

}  // namespace pizarra
