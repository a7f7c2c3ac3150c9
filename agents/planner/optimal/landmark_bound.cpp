#include "agents/planner/optimal/landmark_bound.hpp"

#include <algorithm>

namespace pizarra {

namespace {

bool has(const std::vector<std::size_t>& facts, std::size_t fact) { return std::ranges::binary_search(facts, fact); }

}  // namespace

LandmarkBound::LandmarkBound(const Problem& problem, const Exclusions& exclusions, const FactGroup& group,
                             const std::function<bool()>& cancelled)
    : problem_(problem),
      exclusions_(exclusions),
      reach_(problem, exclusions.actions()),
      no_action_(problem.actions.size()),
      counted_(problem.actions.size()),
      excluded_by_goals_(problem.facts.size()),
      deleters_(problem.facts.size(), Bits(problem.actions.size())) {
  exclusions.actions().for_each([&](std::size_t i) {
    const GroundAction& action = problem.actions[i];
    for (const std::size_t fact : action.deletes) {
      deleters_[fact].set(i);
      if (has(group, fact) && has(action.preconditions, fact)) counted_.set(i);
    }
  });
  counts_every_action_ = exclusions.actions().subset_of(counted_);
  problem.goals.for_each([&](std::size_t goal) { excluded_by_goals_ |= exclusions.with(goal); });
  for (const std::size_t fact : group) add_visit(fact);

  // No action may count twice; the facts with the fewest actions are kept first.
  std::ranges::stable_sort(visits_, {}, [](const Visit& visit) { return visit.both.count(); });
  Bits used(problem.actions.size());
  std::erase_if(visits_, [&](const Visit& visit) {
    if (visit.both.intersects(used)) return true;
    used |= visit.both;
    return false;
  });
  for (Visit& visit : visits_) find_last_leaves(visit, cancelled);
}

void LandmarkBound::add_visit(std::size_t fact) {
  Visit visit{.fact = fact,
              .must_end = excluded_by_goals_.test(fact),
              .enter = no_action_,
              .leave = deleters_[fact],
              .both = no_action_,
              .leave_last = no_action_,
              .ends_after = {}};
  bool fits = true;
  exclusions_.actions().for_each([&](std::size_t i) {
    const GroundAction& action = problem_.actions[i];
    if (has(action.adds, fact)) visit.enter.set(i);
    const bool touches = visit.enter.test(i) || visit.leave.test(i);
    if (touches && visit.leave.test(i) != has(action.preconditions, fact)) fits = false;
  });
  visit.both = visit.enter;
  visit.both |= visit.leave;
  if (fits && visit.enter.any() && visit.leave.any() && visit.both.subset_of(counted_)) {
    visits_.push_back(std::move(visit));
  }
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

void LandmarkBound::find_last_leaves(Visit& visit, const std::function<bool()>& cancelled) {
  Bits afterwards(problem_.facts.size());
  visit.leave.for_each([&](std::size_t i) {
    if (cancelled()) return;
    const Bits after = possible_after(problem_.actions[i]);
    reach_.from(after, visit.both);
    if (!problem_.goals.subset_of(reach_.facts())) return;
    visit.leave_last.set(i);
    afterwards |= after;
  });
  reach_.from(afterwards, visit.both);
  visit.ends_after = Bits(visits_.size());
  for (std::size_t other = 0; other < visits_.size(); ++other) {
    if (!visits_[other].enter.intersects(reach_.actions())) visit.ends_after.set(other);
  }
}

// Whether, by what reach_ found without the visit's actions, the goals need them.
bool LandmarkBound::required(const Visit& visit, const Bits& state) const {
  if (!problem_.goals.subset_of(reach_.facts())) return true;
  Bits must_go = state;
  must_go &= excluded_by_goals_;
  must_go.reset(visit.fact);
  bool stuck = false;
  must_go.for_each([&](std::size_t fact) { stuck = stuck || !deleters_[fact].intersects(reach_.actions()); });
  return stuck;
}

std::optional<std::size_t> LandmarkBound::from(const Bits& state) {
  reach_.from(state, no_action_);
  if (!problem_.goals.subset_of(reach_.facts())) return std::nullopt;
  std::vector<std::size_t> wanted;
  std::vector<Bits> without;  // of every wanted visit: what can be done before its first
  std::optional<std::size_t> current;
  std::size_t steps = 0;
  for (std::size_t i = 0; i < visits_.size(); ++i) {
    const Visit& visit = visits_[i];
    const bool holds = state.test(visit.fact);
    if (holds) current = i;
    if (holds && !visit.must_end) continue;
    if (!holds) reach_.from(state, visit.both);
    if (!holds && !required(visit, state)) continue;
    steps += holds ? 1 : 2;
    wanted.push_back(i);
    without.push_back(holds ? no_action_ : reach_.actions());
  }
  const int extra = fewest_extra(wanted, order_of(wanted, without, current));
  return static_cast<std::size_t>(static_cast<int>(steps) + extra);
}

VisitOrder LandmarkBound::order_of(const std::vector<std::size_t>& wanted, const std::vector<Bits>& without,
                                   std::optional<std::size_t> current) const {
  VisitOrder order(wanted.size());
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    for (std::size_t j = 0; j < wanted.size(); ++j) {
      if (i == j) continue;
      const Visit& other = visits_[wanted[j]];
      if (wanted[i] == current || !other.enter.intersects(without[i])) order.first_before_first(i, j);
      if (wanted[i] != current && !other.leave_last.intersects(without[i])) order.first_before_last(i, j);
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

}  // namespace pizarra
