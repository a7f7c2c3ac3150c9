#include "agents/planner/guided/landmark_bound.hpp"

#include <algorithm>

namespace pizarra::planner {

namespace {

bool has(const std::vector<std::size_t>& facts, std::size_t fact) { return std::ranges::binary_search(facts, fact); }

}  // namespace

std::optional<FactGroup> resource_of_all(const Problem& problem, const Bits& actions,
                                         const std::vector<FactGroup>& groups) {
  for (const FactGroup& group : groups) {
    bool all = true;
    actions.for_each([&](std::size_t i) {
      const GroundAction& action = problem.actions[i];
      all = all && std::ranges::any_of(action.deletes, [&](std::size_t fact) {
              return has(group, fact) && has(action.preconditions, fact);
            });
    });
    if (all) return group;
  }
  return std::nullopt;
}

LandmarkBound::LandmarkBound(const Problem& problem, const Exclusions& exclusions, const FactGroup& group,
                             const std::function<bool()>& cancelled)
    : problem_(problem),
      exclusions_(exclusions),
      counted_(problem.actions.size()),
      excluded_by_goals_(problem.facts.size()),
      adders_(problem.facts.size()),
      deleters_(problem.facts.size()) {
  exclusions.actions().for_each([&](std::size_t i) {
    const GroundAction& action = problem.actions[i];
    for (const std::size_t fact : action.adds) adders_[fact].push_back(static_cast<std::uint32_t>(i));
    for (const std::size_t fact : action.deletes) {
      deleters_[fact].push_back(static_cast<std::uint32_t>(i));
      if (has(group, fact) && has(action.preconditions, fact)) counted_.set(i);
    }
  });
  counts_every_action_ = exclusions.actions().subset_of(counted_);
  problem.goals.for_each([&](std::size_t goal) { excluded_by_goals_ |= exclusions.with(goal); });
  for (const std::size_t fact : group) add_visit(fact);
  keep_disjoint();
  RelaxedReach reach(problem, exclusions.actions());
  for (std::size_t i = 0; i < visits_.size() && !cancelled(); ++i) find_last_leaves(i, reach, cancelled);
  reached_.emplace(problem, exclusions.actions(), visit_of_, visits_.size());
}

void LandmarkBound::add_visit(std::size_t fact) {
  Visit visit{.fact = fact,
              .must_end = excluded_by_goals_.test(fact),
              .enter = adders_[fact],
              .leave = deleters_[fact],
              .leave_last = {},
              .ends_after = {}};
  const auto needs = [&](std::uint32_t action) { return has(problem_.actions[action].preconditions, fact); };
  const auto counted = [&](std::uint32_t action) { return counted_.test(action); };
  const bool fits = !visit.enter.empty() && !visit.leave.empty() && std::ranges::none_of(visit.enter, needs) &&
                    std::ranges::all_of(visit.leave, needs) && std::ranges::all_of(visit.enter, counted) &&
                    std::ranges::all_of(visit.leave, counted);
  if (fits) visits_.push_back(std::move(visit));
}

// No action may count twice; the facts with the fewest actions are kept first.
void LandmarkBound::keep_disjoint() {
  std::ranges::stable_sort(visits_, {}, [](const Visit& visit) { return visit.enter.size() + visit.leave.size(); });
  visit_of_.assign(problem_.actions.size(), RelaxedLandmarks::no_kind);
  std::uint32_t kept = 0;
  std::erase_if(visits_, [&](const Visit& visit) {
    const auto used = [&](std::uint32_t action) { return visit_of_[action] != RelaxedLandmarks::no_kind; };
    if (std::ranges::any_of(visit.enter, used) || std::ranges::any_of(visit.leave, used)) return true;
    for (const std::uint32_t action : visit.enter) visit_of_[action] = kept;
    for (const std::uint32_t action : visit.leave) visit_of_[action] = kept;
    ++kept;
    return false;
  });
}

// What may hold after the action.
Bits LandmarkBound::possible_after(const GroundAction& action) const {
  Bits facts = exclusions_.facts();
  const auto rule_out = [&](std::size_t fact) { facts -= exclusions_.with(fact); };
  std::ranges::for_each(action.adds, rule_out);
  for (const std::size_t fact : action.preconditions) {
    if (!has(action.deletes, fact)) rule_out(fact);
  }
  for (const std::size_t fact : action.deletes) facts.reset(fact);
  return facts;
}

// Whether the goals are in reach of what may hold without the forbidden actions. Mostly their own adders tell.
bool LandmarkBound::goals_in_reach(const Bits& after, const Bits& forbidden, RelaxedReach& reach) const {
  Bits open = problem_.goals;
  open -= after;
  bool lost = false;
  bool sure = true;
  open.for_each([&](std::size_t goal) {
    const auto allowed = [&](std::uint32_t action) { return !forbidden.test(action); };
    const auto at_once = [&](std::uint32_t action) {
      return allowed(action) && applicable(problem_.actions[action], after);
    };
    lost = lost || std::ranges::none_of(adders_[goal], allowed);
    sure = sure && !lost && std::ranges::any_of(adders_[goal], at_once);
  });
  if (lost || sure) return sure;
  reach.from(after, forbidden);
  return problem_.goals.subset_of(reach.facts());
}

void LandmarkBound::find_last_leaves(std::size_t index, RelaxedReach& reach, const std::function<bool()>& cancelled) {
  Visit& visit = visits_[index];
  Bits forbidden(problem_.actions.size());
  for (const std::uint32_t action : visit.enter) forbidden.set(action);
  for (const std::uint32_t action : visit.leave) forbidden.set(action);
  Bits afterwards(problem_.facts.size());
  for (const std::uint32_t action : visit.leave) {
    if (cancelled()) return;
    const Bits after = possible_after(problem_.actions[action]);
    if (!goals_in_reach(after, forbidden, reach)) continue;
    visit.leave_last.push_back(action);
    afterwards |= after;
  }
  reach.from(afterwards, forbidden);
  visit.ends_after = Bits(visits_.size());
  for (std::size_t other = 0; other < visits_.size(); ++other) {
    const auto possible = [&](std::uint32_t action) { return reach.actions().test(action); };
    if (std::ranges::none_of(visits_[other].enter, possible)) visit.ends_after.set(other);
  }
}

// The visits without which the goals are not reached, or what excludes them does not go.
Bits LandmarkBound::required(const Bits& state) const {
  Bits visits(visits_.size());
  problem_.goals.for_each([&](std::size_t goal) { visits |= reached_->of_fact(goal); });
  Bits must_go = state;
  must_go &= excluded_by_goals_;
  must_go.for_each([&](std::size_t fact) { visits |= reached_->of_all(deleters_[fact]); });
  return visits;
}

std::optional<std::size_t> LandmarkBound::from(const Bits& state) {
  reached_->from(state);
  bool in_reach = true;
  problem_.goals.for_each([&](std::size_t goal) { in_reach = in_reach && reached_->reached(goal); });
  if (!in_reach) return std::nullopt;
  const Bits required = this->required(state);
  std::vector<std::size_t> wanted;
  std::optional<std::size_t> current;
  std::size_t steps = 0;
  for (std::size_t i = 0; i < visits_.size(); ++i) {
    const Visit& visit = visits_[i];
    const bool holds = state.test(visit.fact);
    if (holds) current = i;
    if (holds ? !visit.must_end : !required.test(i)) continue;
    steps += holds ? 1 : 2;
    wanted.push_back(i);
  }
  const int extra = fewest_extra(wanted, order_of(wanted, current));
  return static_cast<std::size_t>(static_cast<int>(steps) + extra);
}

VisitOrder LandmarkBound::order_of(const std::vector<std::size_t>& wanted, std::optional<std::size_t> current) const {
  VisitOrder order(wanted.size());
  for (std::size_t j = 0; j < wanted.size(); ++j) {
    const Visit& later = visits_[wanted[j]];
    const Bits before_first = reached_->of_all(later.enter);
    const Bits before_last = reached_->of_all(later.leave_last);
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      if (i == j) continue;
      const bool is_current = wanted[i] == current;
      if (is_current || before_first.test(wanted[i])) order.first_before_first(i, j);
      if (!is_current && before_last.test(wanted[i])) order.first_before_last(i, j);
      if (visits_[wanted[i]].ends_after.test(wanted[j])) order.last_before_last(j, i);
    }
  }
  return order;
}

// What repeated visits add. A visit that need not end saves its end if it is the last of all.
int LandmarkBound::fewest_extra(const std::vector<std::size_t>& wanted, const VisitOrder& order) const {
  int extra = 2 * static_cast<int>(order.fewest_repeats());
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    if (visits_[wanted[i]].must_end) continue;
    VisitOrder ending = order;
    for (std::size_t j = 0; j < wanted.size(); ++j) {
      if (j != i) ending.last_before_last(j, i);
    }
    extra = std::min(extra, 2 * static_cast<int>(ending.fewest_repeats()) - 1);
  }
  return extra;
}

}  // namespace pizarra::planner
