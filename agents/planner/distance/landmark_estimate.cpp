#include "agents/planner/distance/landmark_estimate.hpp"

#include <algorithm>
#include <iterator>

namespace pizarra::planner {

namespace {

constexpr FactIndex nothing = ~FactIndex{0};
constexpr std::uint32_t unreachable = ~std::uint32_t{0};
constexpr FactIndex facts_between_looks = 1024;
// The weight of an event against a fact that has to be made true by one counted already, and the worth of a goal that
// can be made true right now: in doubt, finish something before beginning another thing.
constexpr Distance event_weight = 4;
constexpr Distance ready_weight = 2;

std::uint32_t rank_in(std::span<const FactIndex> group, FactIndex fact) {
  return static_cast<std::uint32_t>(std::ranges::lower_bound(group, fact) - group.begin());
}

// The elements common to the rows of all the actions.
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

LandmarkEstimate::LandmarkEstimate(const CompactProblem& problem, const InvariantGroups& invariants,
                                   const std::function<bool()>& cancelled)
    : problem_(problem),
      invariants_(invariants),
      state_(problem.facts()),
      holds_(invariants.groups().size(), {nothing, 0}),
      marks_(problem.facts()),
      goal_hops_(problem.goals().count(), 0),
      awaited_(invariants.groups().size()) {
  problem.goals().for_each([&](std::size_t goal) { goals_.push_back(static_cast<FactIndex>(goal)); });
  if (learn_changes(cancelled) && learn_hops(cancelled)) look_at(problem.initials());
}

bool LandmarkEstimate::learn_changes(const std::function<bool()>& cancelled) {
  const auto preconditions = [&](ActionIndex action) { return problem_.preconditions(action); };
  const auto adds = [&](ActionIndex action) { return problem_.adds(action); };
  const auto put = [&](const auto& row) {
    const auto begin = static_cast<std::uint32_t>(items_.size());
    items_.insert(items_.end(), row.begin(), row.end());
    return begin;
  };
  for (FactIndex fact = 0; fact < problem_.facts(); ++fact) {
    if (fact % facts_between_looks == 0 && cancelled()) return false;
    const std::span<const ActionIndex> adding = problem_.adding(fact), deleting = problem_.deleting(fact);
    const std::vector<FactIndex> needed = shared(deleting, preconditions), added = shared(deleting, adds);
    std::vector<FactIndex> only_needed;
    std::ranges::set_difference(needed, added, std::back_inserter(only_needed));
    Rows rows{};
    rows.groups = put(invariants_.groups_of(fact));
    rows.ranks = static_cast<std::uint32_t>(items_.size());
    for (const std::uint32_t group : invariants_.groups_of(fact)) {
      items_.push_back(rank_in(invariants_.groups()[group], fact));
    }
    rows.needs = put(shared(adding, preconditions));
    rows.leaving_adds = put(added);
    rows.leaving = put(only_needed);
    rows.end = static_cast<std::uint32_t>(items_.size());
    rows.can_come = !adding.empty();
    rows.can_go = !deleting.empty();
    rows.is_goal = problem_.goals().test(fact);
    rows_.push_back(rows);
  }
  return true;
}

bool LandmarkEstimate::learn_hops(const std::function<bool()>& cancelled) {
  for (const FactIndex goal : goals_) {
    if (cancelled()) return false;
    hops_of_.emplace_back();
    for (const std::uint32_t group : groups_of(goal)) {
      hops_of_.back().push_back({group, static_cast<std::uint32_t>(hops_.size())});
      std::ranges::copy(hops_to(goal, invariants_.groups()[group]), std::back_inserter(hops_));
    }
  }
  return true;
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
  for (const Hops& hops : hops_of_[goal]) {
    const Holds& here = holds_[hops.group];
    if (here.fact == nothing) return unreachable;
    most = std::max(most, hops_[hops.from + here.rank]);
  }
  return most;
}

void LandmarkEstimate::look_at(const Bits& state) {
  Bits gone = state_, come = state;
  gone -= state;
  come -= state_;
  gone.for_each([&](std::size_t fact) { reset(static_cast<FactIndex>(fact)); });
  come.for_each([&](std::size_t fact) { set(static_cast<FactIndex>(fact)); });
  state_ = state;
}

void LandmarkEstimate::set(FactIndex fact) {
  marks_[fact].holds = true;
  const Rows& rows = rows_[fact];
  const std::uint32_t groups = rows.ranks - rows.groups;
  for (std::uint32_t i = 0; i < groups; ++i) holds_[items_[rows.groups + i]] = {fact, items_[rows.ranks + i]};
}

void LandmarkEstimate::reset(FactIndex fact) {
  marks_[fact].holds = false;
  for (const std::uint32_t group : groups_of(fact)) {
    if (holds_[group].fact == fact) holds_[group].fact = nothing;
  }
}

std::optional<Distance> LandmarkEstimate::beyond(ActionIndex action) {
  const auto adds = problem_.adds(action), deletes = problem_.deletes(action);
  added_.clear();
  deleted_.clear();
  std::ranges::copy_if(adds, std::back_inserter(added_), [&](FactIndex fact) { return !marks_[fact].holds; });
  std::ranges::copy_if(deletes, std::back_inserter(deleted_), [&](FactIndex fact) { return marks_[fact].holds; });
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
    if (marks_[goals_[i]].holds) continue;
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
    if (marks_[goals_[i]].holds) continue;
    std::uint32_t awaited = 0;
    for (const Hops& hops : hops_of_[i]) awaited = std::max(awaited, awaited_[hops.group].count);
    if (goal_hops_[i] > awaited) events_ += goal_hops_[i] - awaited;
    any_ready = any_ready || ready(goals_[i]);
  }
  return event_weight * events_ + facts_ + (any_ready ? 0 : ready_weight);
}

inline void LandmarkEstimate::push(FactIndex fact) {
  Marks& marks = marks_[fact];
  if (marks.holds || marks.pending == evaluation_) return;
  marks.pending = evaluation_;
  open_.push_back(fact);
  ++facts_;
  for (const std::uint32_t group : groups_of(fact)) {
    Awaited& awaited = awaited_[group];
    if (awaited.in != evaluation_) awaited = {0, evaluation_};
    ++awaited.count;
  }
}

// Whether one action may make the goal true for good.
bool LandmarkEstimate::ready(FactIndex goal) const {
  return std::ranges::all_of(row(rows_[goal].needs, rows_[goal].leaving_adds),
                             [&](FactIndex fact) { return marks_[fact].holds; }) &&
         std::ranges::all_of(groups_of(goal), [&](std::uint32_t group) { return awaited_[group].count == 1; });
}

inline void LandmarkEstimate::count_once(FactIndex event) {
  if (marks_[event].counted == evaluation_) return;
  marks_[event].counted = evaluation_;
  ++events_;
}

// Whether all actions that take away what is in the way make the fact true.
inline bool LandmarkEstimate::makes_room(FactIndex in_the_way, FactIndex fact) const {
  const Rows& rows = rows_[in_the_way];
  for (std::uint32_t i = rows.leaving_adds; i < rows.leaving; ++i) {
    if (items_[i] == fact) return true;
  }
  return false;
}

// The fact does not hold and has to.
inline bool LandmarkEstimate::must_happen(FactIndex fact) {
  const Rows& rows = rows_[fact];
  if (!rows.can_come) return false;
  for (const FactIndex needed : row(rows.needs, rows.leaving_adds)) push(needed);
  bool comes_alone = true;
  for (const std::uint32_t group : groups_of(fact)) {
    const FactIndex in_the_way = holds_[group].fact;
    if (in_the_way == nothing) return false;
    if (marks_[in_the_way].taken != evaluation_ && !must_be_taken_away(in_the_way)) return false;
    if (!makes_room(in_the_way, fact)) continue;
    count_once(in_the_way);
    comes_alone = false;
  }
  if (comes_alone) count_once(fact);
  return true;
}

// The fact holds and has to end, which was not known yet; a goal has to come back.
bool LandmarkEstimate::must_be_taken_away(FactIndex fact) {
  marks_[fact].taken = evaluation_;
  const Rows& rows = rows_[fact];
  if (!rows.can_go) return false;
  for (const FactIndex other : row(rows.leaving_adds, rows.end)) push(other);
  if (!rows.is_goal) return true;
  ++events_;
  for (const FactIndex needed : row(rows.needs, rows.leaving_adds)) push(needed);
  return true;
}

}  // namespace pizarra::planner
