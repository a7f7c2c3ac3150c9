#include "agents/planner/distance/landmark_estimate.hpp"

#include <algorithm>
#include <iterator>

namespace pizarra {

namespace {

constexpr FactIndex nothing = ~FactIndex{0};
constexpr std::uint32_t unreachable = ~std::uint32_t{0};
// What an event weighs against a fact that has to be made true by one counted already, and what it is worth that a goal
// can be made true right now: in doubt, finish something before beginning another thing.
constexpr Distance event_weight = 4;
constexpr Distance ready_weight = 2;

std::size_t rank_in(std::span<const FactIndex> group, FactIndex fact) {
  return static_cast<std::size_t>(std::ranges::lower_bound(group, fact) - group.begin());
}

// What is common to the rows of all the actions.
std::vector<FactIndex> shared(std::span<const ActionIndex> actions, const auto& row_of) {
  std::vector<FactIndex> common;
  for (std::size_t i = 0; i < actions.size(); ++i) {
    const std::span<const FactIndex> row = row_of(actions[i]);
    if (i == 0) {
      common.assign(row.begin(), row.end());
    } else {
      std::erase_if(common, [&](FactIndex fact) { return !std::ranges::binary_search(row, fact); });
    }
    if (common.empty()) break;
  }
  return common;
}

}  // namespace

LandmarkEstimate::LandmarkEstimate(const CompactProblem& problem, const InvariantGroups& invariants)
    : problem_(problem),
      invariants_(invariants),
      state_(problem.initials()),
      holds_(invariants.groups().size(), {nothing, 0}),
      marks_(problem.facts()),
      goal_hops_(problem.goals().count(), 0),
      awaited_(invariants.groups().size()) {
  learn_changes();
  problem.goals().for_each([&](std::size_t goal) {
    goals_.push_back(static_cast<FactIndex>(goal));
    hops_.push_back({});
    for (const std::uint32_t group : invariants.groups_of(static_cast<FactIndex>(goal))) {
      hops_.back().push_back(hops_to(static_cast<FactIndex>(goal), invariants.groups()[group]));
    }
  });
}

void LandmarkEstimate::learn_changes() {
  const auto preconditions = [&](ActionIndex action) { return problem_.preconditions(action); };
  const auto adds = [&](ActionIndex action) { return problem_.adds(action); };
  for (FactIndex fact = 0; fact < problem_.facts(); ++fact) {
    const std::span<const ActionIndex> adding = problem_.adding(fact), deleting = problem_.deleting(fact);
    can_come_.push_back(adding.empty() ? 0 : 1);
    can_go_.push_back(deleting.empty() ? 0 : 1);
    needs_.add(shared(adding, preconditions));
    const std::vector<FactIndex> needed = shared(deleting, preconditions), added = shared(deleting, adds);
    std::vector<FactIndex> both;
    std::ranges::set_union(needed, added, std::back_inserter(both));
    leaving_.add(both);
    leaving_adds_.add(added);
    std::vector<std::uint32_t> ranks;
    for (const std::uint32_t group : invariants_.groups_of(fact)) {
      ranks.push_back(static_cast<std::uint32_t>(rank_in(invariants_.groups()[group], fact)));
    }
    ranks_.add(ranks);
  }
}

// From every fact of the group to the goal, which is one of them, by actions that put one in the other's place.
std::vector<std::uint32_t> LandmarkEstimate::hops_to(FactIndex goal, std::span<const FactIndex> group) const {
  std::vector<std::uint32_t> hops(group.size(), unreachable);
  std::vector<FactIndex> open{goal};
  const auto rank = [&](FactIndex fact) { return rank_in(group, fact); };
  hops[rank(goal)] = 0;
  for (std::size_t i = 0; i < open.size(); ++i) {
    for (const ActionIndex action : problem_.adding(open[i])) {
      for (const FactIndex from : problem_.preconditions(action)) {
        if (!std::ranges::binary_search(group, from) || hops[rank(from)] != unreachable) continue;
        hops[rank(from)] = hops[rank(open[i])] + 1;
        open.push_back(from);
      }
    }
  }
  return hops;
}

// How often the goal's place has to change hands; the longest way in any of its groups.
std::uint32_t LandmarkEstimate::hops_left(std::size_t goal) const {
  std::uint32_t most = 0;
  const auto groups = invariants_.groups_of(goals_[goal]);
  for (std::size_t i = 0; i < groups.size(); ++i) {
    const Holds& holds = holds_[groups[i]];
    if (holds.fact == nothing) return unreachable;
    most = std::max(most, hops_[goal][i][holds.rank]);
  }
  return most;
}

void LandmarkEstimate::look_at(const Bits& state) {
  state_ = state;
  std::ranges::fill(holds_, Holds{nothing, 0});
  state.for_each([&](std::size_t fact) { set(static_cast<FactIndex>(fact)); });
}

void LandmarkEstimate::set(FactIndex fact) {
  state_.set(fact);
  const auto groups = invariants_.groups_of(fact), ranks = ranks_[fact];
  for (std::size_t i = 0; i < groups.size(); ++i) holds_[groups[i]] = {fact, ranks[i]};
}

void LandmarkEstimate::reset(FactIndex fact) {
  state_.reset(fact);
  for (const std::uint32_t group : invariants_.groups_of(fact)) {
    if (holds_[group].fact == fact) holds_[group].fact = nothing;
  }
}

std::optional<Distance> LandmarkEstimate::beyond(ActionIndex action) {
  const auto adds = problem_.adds(action), deletes = problem_.deletes(action);
  added_.clear();
  deleted_.clear();
  std::ranges::copy_if(adds, std::back_inserter(added_), [&](FactIndex fact) { return !state_.test(fact); });
  std::ranges::copy_if(deletes, std::back_inserter(deleted_), [&](FactIndex fact) { return state_.test(fact); });
  for (const FactIndex fact : deleted_) reset(fact);
  for (const FactIndex fact : added_) set(fact);
  const std::optional<Distance> distance = here();
  for (const FactIndex fact : added_) reset(fact);
  for (const FactIndex fact : deleted_) set(fact);
  return distance;
}

std::optional<Distance> LandmarkEstimate::here() {
  ++evaluation_;
  events_ = 0;
  facts_ = 0;
  open_.clear();
  for (std::size_t i = 0; i < goals_.size(); ++i) {
    if (state_.test(goals_[i])) continue;
    goal_hops_[i] = hops_left(i);
    if (goal_hops_[i] == unreachable) return std::nullopt;
    push(goals_[i]);
  }
  while (!open_.empty()) {
    const FactIndex fact = open_.back();
    open_.pop_back();
    if (!must_happen(fact)) return std::nullopt;
  }
  bool any_ready = false;
  for (std::size_t i = 0; i < goals_.size(); ++i) {
    if (state_.test(goals_[i])) continue;
    std::uint32_t awaited = 0;
    for (const std::uint32_t group : invariants_.groups_of(goals_[i]))
      awaited = std::max(awaited, awaited_[group].count);
    if (goal_hops_[i] > awaited) events_ += goal_hops_[i] - awaited;
    any_ready = any_ready || ready(goals_[i]);
  }
  return event_weight * events_ + facts_ + (any_ready ? 0 : ready_weight);
}

void LandmarkEstimate::push(FactIndex fact) {
  if (state_.test(fact) || marks_[fact].pending == evaluation_) return;
  marks_[fact].pending = evaluation_;
  open_.push_back(fact);
  ++facts_;
  for (const std::uint32_t group : invariants_.groups_of(fact)) {
    Awaited& awaited = awaited_[group];
    if (awaited.in != evaluation_) awaited = {0, evaluation_};
    ++awaited.count;
  }
}

// Whether one action may make the goal true for good.
bool LandmarkEstimate::ready(FactIndex goal) const {
  return std::ranges::all_of(needs_[goal], [&](FactIndex fact) { return state_.test(fact); }) &&
         std::ranges::all_of(invariants_.groups_of(goal),
                             [&](std::uint32_t group) { return awaited_[group].count == 1; });
}

void LandmarkEstimate::count_once(FactIndex event) {
  if (marks_[event].counted == evaluation_) return;
  marks_[event].counted = evaluation_;
  ++events_;
}

// The fact does not hold and has to.
bool LandmarkEstimate::must_happen(FactIndex fact) {
  if (can_come_[fact] == 0) return false;
  for (const FactIndex needed : needs_[fact]) push(needed);
  bool comes_alone = true;
  for (const std::uint32_t group : invariants_.groups_of(fact)) {
    const FactIndex in_the_way = holds_[group].fact;
    if (in_the_way == nothing || !must_be_taken_away(in_the_way)) return false;
    if (std::ranges::find(leaving_adds_[in_the_way], fact) == leaving_adds_[in_the_way].end()) continue;
    count_once(in_the_way);
    comes_alone = false;
  }
  if (comes_alone) count_once(fact);
  return true;
}

// The fact holds and has to end; a goal has to come back.
bool LandmarkEstimate::must_be_taken_away(FactIndex fact) {
  if (marks_[fact].taken == evaluation_) return true;
  marks_[fact].taken = evaluation_;
  if (can_go_[fact] == 0) return false;
  for (const FactIndex other : leaving_[fact]) push(other);
  if (!problem_.goals().test(fact)) return true;
  ++events_;
  for (const FactIndex needed : needs_[fact]) push(needed);
  return true;
}

}  // namespace pizarra
