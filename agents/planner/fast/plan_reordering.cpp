#include "agents/planner/fast/plan_reordering.hpp"

#include <algorithm>
#include <ranges>

namespace pizarra::planner {

namespace {

constexpr std::size_t longest_piece = 8;
constexpr std::size_t longest_way_there = 3;
constexpr std::size_t most_ways_out = 1;

bool has(std::span<const FactIndex> facts, FactIndex fact) { return std::ranges::binary_search(facts, fact); }

}  // namespace

PlanReordering::PlanReordering(const CompactProblem& problem, std::vector<ActionIndex> plan, Random& random)
    : problem_(problem), random_(random), plan_(std::move(plan)) {
  Bits makes_goal(problem.actions());
  problem.goals().for_each([&](std::size_t goal) {
    for (const ActionIndex action : problem.adding(static_cast<FactIndex>(goal))) makes_goal.set(action);
  });
  std::vector<std::vector<ActionIndex>> makers(problem.facts());
  makes_goal.for_each([&](std::size_t action) {
    for (const FactIndex fact : problem.preconditions(static_cast<ActionIndex>(action))) {
      makers[fact].push_back(static_cast<ActionIndex>(action));
    }
  });
  for (const std::vector<ActionIndex>& row : makers) goal_makers_.add(row);
}

bool PlanReordering::try_once() {
  if (plan_.size() < 2) return false;
  if (random_.below(4) == 0 || !prepare_for_going_on()) move_a_piece();
  if (!redo() || done_.size() > plan_.size()) return false;
  const bool shorter = done_.size() < plan_.size();
  plan_ = done_;
  return shorter;
}

void PlanReordering::move_a_piece() {
  order_ = plan_;
  const std::size_t length = 1 + random_.below(std::min(longest_piece, plan_.size() - 1));
  const std::size_t from = random_.below(plan_.size() - length + 1);
  const std::size_t to = random_.below(plan_.size() - length + 1);
  const auto at = [&](std::size_t index) { return order_.begin() + static_cast<std::ptrdiff_t>(index); };
  begin_ = std::min(from, to);
  if (from < to) {
    std::rotate(at(from), at(from + length), at(to + length));
  } else {
    std::rotate(at(to), at(from), at(from + length));
  }
}

// A later action takes away a fact that an action made, and another goes on with the fact that the later one made: it
// might have gone on at once, if what else it needs had been made before.
bool PlanReordering::prepare_for_going_on() {
  const std::size_t there = random_.below(plan_.size());
  const auto adds = problem_.adds(plan_[there]);
  if (adds.empty()) return false;
  const FactIndex made = adds[random_.below(adds.size())];
  std::size_t back = there + 1;
  while (back < plan_.size() && !has(problem_.deletes(plan_[back]), made)) ++back;
  if (back == plan_.size()) return false;
  const auto given = problem_.adds(plan_[back]);
  const auto is_given = [&](FactIndex fact) { return has(given, fact); };
  std::size_t on = back + 1;
  while (on < plan_.size() && std::ranges::none_of(problem_.preconditions(plan_[on]), is_given)) ++on;
  if (on == plan_.size()) return false;
  begin_ = there - random_.below(std::min(there, longest_way_there) + 1);
  Bits holds = problem_.initials();
  for (std::size_t i = 0; i < begin_; ++i) problem_.apply(plan_[i], holds);
  Bits wanted(problem_.facts());
  for (const FactIndex fact : problem_.preconditions(plan_[on])) {
    if (!holds.test(fact) && !is_given(fact)) wanted.set(fact);
  }
  return hurry(on, {there, back}, holds, wanted);
}

// Brings what makes the wanted facts to begin_, with what makes what that needs and what does not hold there.
bool PlanReordering::hurry(std::size_t end, std::pair<std::size_t, std::size_t> but, const Bits& holds, Bits& wanted) {
  std::vector<ActionIndex> hurried, others;
  for (std::size_t i = end; i-- > begin_;) {
    const ActionIndex action = plan_[i];
    const bool makes = std::ranges::any_of(problem_.adds(action), [&](FactIndex fact) { return wanted.test(fact); });
    if (!makes || i == but.first || i == but.second) {
      others.push_back(action);
      continue;
    }
    hurried.push_back(action);
    for (const FactIndex fact : problem_.adds(action)) wanted.reset(fact);
    for (const FactIndex fact : problem_.preconditions(action)) {
      if (!holds.test(fact)) wanted.set(fact);
    }
  }
  order_ = plan_;
  const auto rest =
      std::ranges::copy(hurried | std::views::reverse, order_.begin() + static_cast<std::ptrdiff_t>(begin_));
  std::ranges::copy(others | std::views::reverse, rest.out);
  return !hurried.empty();
}

// Into done_; false where it gets stuck.
bool PlanReordering::redo() {
  const auto begin = order_.begin() + static_cast<std::ptrdiff_t>(begin_);
  done_.assign(order_.begin(), begin);
  order_.erase(order_.begin(), begin);
  Bits state = problem_.initials();
  for (const ActionIndex action : done_) problem_.apply(action, state);
  std::size_t ways_out = 0;
  while (!problem_.goals().subset_of(state)) {
    std::optional<ActionIndex> action = next(state);
    if (!action && ways_out++ < most_ways_out) action = way_out(state);
    if (!action || done_.size() == plan_.size()) return false;
    problem_.apply(*action, state);
    done_.push_back(*action);
  }
  return true;
}

// Takes it out of order_. An action that makes a goal true is looked for where the action before has made a fact true
// that it needs.
std::optional<ActionIndex> PlanReordering::next(const Bits& state) {
  const auto first =
      std::ranges::find_if(order_, [&](ActionIndex action) { return problem_.applicable(action, state); });
  if (first == order_.end()) return std::nullopt;
  if (!done_.empty()) {
    for (const FactIndex fact : problem_.adds(done_.back())) {
      for (const ActionIndex action : goal_makers_[fact]) {
        if (!problem_.applicable(action, state) || !makes_a_goal(action, state)) continue;
        const auto later = std::find(first, order_.end(), action);
        if (later == first || later == order_.end() || !suffices(later - order_.begin(), state)) continue;
        order_.swap(rest_);
        return action;
      }
    }
  }
  const ActionIndex action = *first;
  order_.erase(first);
  return action;
}

// Where nothing of the order can be done: what makes possible the first action that anything can, and undoes least of
// what is needed. Its way back joins the order.
std::optional<ActionIndex> PlanReordering::way_out(const Bits& state) {
  Bits needed(problem_.facts());
  for (const ActionIndex action : order_) {
    for (const FactIndex fact : problem_.preconditions(action)) needed.set(fact);
  }
  std::optional<ActionIndex> best;
  std::size_t least = 0;
  const auto consider = [&](ActionIndex action) {
    if (!problem_.applicable(action, state)) return;
    std::size_t harm = 0;
    for (const FactIndex fact : problem_.deletes(action)) harm += needed.test(fact) ? 2 : 1;
    if (best && harm >= least) return;
    best = action;
    least = harm;
  };
  for (auto blocked = order_.begin(); blocked != order_.end() && !best; ++blocked) {
    for (const FactIndex fact : problem_.preconditions(*blocked)) {
      if (!state.test(fact)) std::ranges::for_each(problem_.adding(fact), consider);
    }
  }
  return best && plan_way_back(*best, state) ? best : std::nullopt;
}

// Just before the first action that needs what the way out takes away.
bool PlanReordering::plan_way_back(ActionIndex out, Bits state) {
  problem_.apply(out, state);
  const auto user = std::ranges::find_if(order_, [&](ActionIndex action) {
    return std::ranges::any_of(problem_.deletes(out),
                               [&](FactIndex fact) { return has(problem_.preconditions(action), fact); });
  });
  if (user == order_.end()) return true;
  for (const FactIndex fact : problem_.preconditions(*user)) {
    if (!has(problem_.deletes(out), fact)) continue;
    const auto adding = problem_.adding(fact);
    const auto back =
        std::ranges::find_if(adding, [&](ActionIndex action) { return problem_.applicable(action, state); });
    if (back == adding.end()) return false;
    order_.insert(user, *back);
    return true;
  }
  return false;
}

bool PlanReordering::makes_a_goal(ActionIndex action, const Bits& state) const {
  return std::ranges::any_of(problem_.adds(action),
                             [&](FactIndex fact) { return problem_.goals().test(fact) && !state.test(fact); });
}

// Whether the goals are reached when the action is done now and then the others, as far as they can be; into rest_.
bool PlanReordering::suffices(std::ptrdiff_t index, Bits state) {
  problem_.apply(order_[static_cast<std::size_t>(index)], state);
  rest_.clear();
  for (std::size_t i = 0; i < order_.size(); ++i) {
    if (static_cast<std::ptrdiff_t>(i) == index || !problem_.applicable(order_[i], state)) continue;
    problem_.apply(order_[i], state);
    rest_.push_back(order_[i]);
  }
  return problem_.goals().subset_of(state);
}

}  // namespace pizarra::planner
