#include "agents/planner/guided/guided_search.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <limits>
#include <utility>

namespace pizarra::planner {

GuidedSearch::GuidedSearch(const Problem& problem, Nearness& nearness, LandmarkBound& bound, const DeadEnds* dead_ends)
    : problem_(problem), nearness_(nearness), bound_(bound), dead_ends_(dead_ends) {}

Outcome GuidedSearch::ended(Outcome::Kind kind, std::string spent) const {
  return {.kind = kind, .spent = std::move(spent), .nodes = nodes_};
}

std::size_t GuidedSearch::know(const Bits& state) {
  const auto [known, is_new] = index_.emplace(state, known_.size());
  if (is_new) known_.push_back({.state = state});
  return known->second;
}

void GuidedSearch::ask_bound(Known& known) {
  if (known.asked) return;
  ++nodes_;
  known.asked = true;
  const bool hopeless = dead_ends_ != nullptr && dead_ends_->contain(known.state);
  known.at_least = hopeless ? no_way : std::max(known.at_least, bound_.from(known.state).value_or(no_way));
}

void GuidedSearch::open(std::size_t index) {
  const std::size_t total = known_[index].steps + known_[index].at_least;
  if (open_.size() <= total) open_.resize(total + 1);
  open_[total].push_back(index);
}

void GuidedSearch::reach(const Bits& state, std::size_t from, std::size_t action, std::size_t steps) {
  const std::size_t index = know(state);
  Known& known = known_[index];
  if (known.at_least == no_way || (known.run == run_ && known.steps <= steps)) return;
  known.run = run_;
  known.from = from;
  known.action = action;
  known.steps = steps;
  known.expanded = false;
  // A step brings the goals nearer by one at most.
  if (known_[from].at_least > 0) known.at_least = std::max(known.at_least, known_[from].at_least - 1);
  open(index);
}

void GuidedSearch::expand(std::size_t index, const std::function<bool()>& cancelled) {
  known_[index].expanded = true;
  expanded_.push_back(index);
  struct Way {
    ActionIndex action;
    Distance distance;
  };
  std::vector<Way> ways;
  LandmarkEstimate& estimate = nearness_.estimate;
  estimate.look_at(known_[index].state);
  nearness_.compact.for_each_applicable(known_[index].state, [&](ActionIndex action) {
    ways.push_back({action, estimate.beyond(action).value_or(std::numeric_limits<Distance>::max())});
  });
  // The newest are looked at first.
  std::ranges::sort(ways, std::greater{}, [](const Way& way) { return std::pair(way.distance, way.action); });
  for (const Way& way : ways) {
    if (cancelled()) return;  // and run() ends, for the state is not wholly expanded
    reach(after(known_[index].state, problem_.actions[way.action]), index, way.action, known_[index].steps + 1);
  }
}

// A state from which the goals were nearer than this would have made the plan shorter.
void GuidedSearch::learn(std::size_t length) {
  for (const std::size_t index : expanded_) {
    Known& known = known_[index];
    known.at_least = std::max(known.at_least, length - known.steps);
  }
}

Outcome GuidedSearch::plan_to(std::size_t index) {
  Outcome outcome = ended(Outcome::Kind::plan);
  outcome.shortest = true;
  learn(known_[index].steps);
  for (; known_[index].steps != 0; index = known_[index].from) outcome.steps.push_back({known_[index].action});
  std::ranges::reverse(outcome.steps);
  return outcome;
}

Outcome GuidedSearch::run(const Budget& budget, const std::function<bool()>& cancelled) {
  const std::size_t bytes_a_state = 2 * problem_.initials.words().size() * 8 + 200;
  ++run_;
  nodes_ = 0;
  open_.clear();
  expanded_.clear();
  const std::size_t start = know(problem_.initials);
  reach(problem_.initials, start, 0, 0);
  for (std::size_t total = 0; total < open_.size(); ++total) {
    while (!open_[total].empty()) {
      const std::size_t index = open_[total].back();
      open_[total].pop_back();
      Known& here = known_[index];
      if (here.expanded || here.at_least == no_way || here.steps + here.at_least != total) continue;
      ask_bound(here);
      if (here.at_least == no_way) continue;
      if (here.steps + here.at_least != total) {
        open(index);
        continue;
      }
      if (problem_.goals.subset_of(here.state)) return plan_to(index);
      if (cancelled()) return ended(Outcome::Kind::cancelled);
      if (nodes_ > budget.nodes) return ended(Outcome::Kind::gave_up, fmt::format("{} states", budget.nodes));
      if (known_.size() * bytes_a_state > budget.bytes) {
        return ended(Outcome::Kind::gave_up, fmt::format("{} MB of memory", budget.bytes >> 20));
      }
      expand(index, cancelled);
    }
  }
  if (cancelled()) return ended(Outcome::Kind::cancelled);
  Outcome outcome = ended(Outcome::Kind::none);
  outcome.culprits = problem_.goals.members();
  return outcome;
}

}  // namespace pizarra::planner
