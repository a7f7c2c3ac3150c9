#include "agents/planner/optimal/step_encoding.hpp"

#include <algorithm>

namespace pizarra::planner {

namespace {

bool has(const std::vector<std::size_t>& facts, std::size_t fact) { return std::ranges::binary_search(facts, fact); }

}  // namespace

StepEncoding::StepEncoding(const Problem& problem, const Exclusions& exclusions, RegressionGraph& regression,
                           CaDiCaL::Solver& solver)
    : problem_(problem),
      exclusions_(exclusions),
      regression_(regression),
      solver_(solver),
      groups_(exclusion_groups(exclusions)),
      adders_(problem.facts.size()),
      deleters_(problem.facts.size()) {
  for (std::size_t action = 0; action < problem.actions.size(); ++action) {
    for (const std::size_t fact : problem.actions[action].adds) adders_[fact].push_back(action);
    for (const std::size_t fact : problem.actions[action].deletes) deleters_[fact].push_back(action);
  }
  find_rivals();
  add_layer();
  problem.goals.for_each([&](std::size_t goal) { clause({facts_.front()[goal]}); });
}

// Actions that delete the same fact, one of which needs it, unless facts that exclude each other keep them apart.
void StepEncoding::find_rivals() {
  const auto kept_apart = [&](const std::vector<std::size_t>& facts, const std::vector<std::size_t>& others) {
    return std::ranges::any_of(facts, [&](std::size_t fact) {
      return std::ranges::any_of(others, [&](std::size_t o) { return exclusions_.with(fact).test(o); });
    });
  };
  for (std::size_t fact = 0; fact < problem_.facts.size(); ++fact) {
    const std::vector<std::size_t>& deleters = deleters_[fact];
    for (std::size_t i = 0; i < deleters.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        const GroundAction& one = problem_.actions[deleters[i]];
        const GroundAction& other = problem_.actions[deleters[j]];
        if (!(has(one.preconditions, fact) || has(other.preconditions, fact))) continue;
        if (kept_apart(one.preconditions, other.preconditions) || kept_apart(one.adds, other.adds)) continue;
        rivals_.emplace_back(deleters[i], deleters[j]);
      }
    }
  }
}

void StepEncoding::add_steps(std::size_t steps) {
  while (actions_.size() < steps) {
    add_layer();
    add_actions();
    add_effects();
    add_frames();
    add_rivals();
  }
}

// A literal 0 is false, and left out.
void StepEncoding::clause(std::initializer_list<int> literals) {
  for (const int literal : literals) {
    if (literal == 0) continue;
    solver_.add(literal);
    ++size_;
  }
  solver_.add(0);
}

void StepEncoding::add_layer() {
  facts_.emplace_back(problem_.facts.size(), 0);
  Layer& facts = facts_.back();
  const Bits& present = regression_.fact_level(facts_.size() - 1).present;
  present.for_each([&](std::size_t fact) { facts[fact] = ++last_variable_; });
  add_exclusions();
}

void StepEncoding::add_actions() {
  actions_.emplace_back(problem_.actions.size(), 0);
  const std::size_t step = actions_.size();
  regression_.actions(step).for_each([&](std::size_t i) {
    const GroundAction& action = problem_.actions[i];
    const bool there =
        std::ranges::all_of(action.preconditions, [&](std::size_t fact) { return facts_[step][fact] != 0; }) &&
        std::ranges::all_of(action.adds, [&](std::size_t fact) { return facts_[step - 1][fact] != 0; });
    if (there) actions_.back()[i] = ++last_variable_;
  });
}

void StepEncoding::add_effects() {
  const Layer& before = facts_.back();
  const Layer& after = facts_[facts_.size() - 2];
  for (std::size_t i = 0; i < problem_.actions.size(); ++i) {
    const int variable = actions_.back()[i];
    if (variable == 0) continue;
    const GroundAction& action = problem_.actions[i];
    for (const std::size_t fact : action.preconditions) {
      clause({-variable, before[fact]});
      if (!has(action.deletes, fact)) clause({-variable, after[fact]});
    }
    for (const std::size_t fact : action.adds) clause({-variable, after[fact]});
    for (const std::size_t fact : action.deletes) {
      if (after[fact] != 0) clause({-variable, -after[fact]});
    }
  }
}

void StepEncoding::frame(int literal, int otherwise, const std::vector<std::size_t>& actions) {
  solver_.add(literal);
  if (otherwise != 0) solver_.add(otherwise);
  for (const std::size_t action : actions) {
    if (actions_.back()[action] == 0) continue;
    solver_.add(actions_.back()[action]);
    ++size_;
  }
  solver_.add(0);
}

// A fact changes only because of an action.
void StepEncoding::add_frames() {
  for (std::size_t fact = 0; fact < problem_.facts.size(); ++fact) {
    const int before = facts_.back()[fact];
    const int after = facts_[facts_.size() - 2][fact];
    if (after != 0) frame(-after, before, adders_[fact]);
    if (before != 0) frame(-before, after, deleters_[fact]);
  }
}

void StepEncoding::add_rivals() {
  for (const auto& [one, other] : rivals_) {
    const int a = actions_.back()[one];
    const int b = actions_.back()[other];
    if (a != 0 && b != 0) clause({-a, -b});
  }
}

void StepEncoding::add_exclusions() {
  const Layer& facts = facts_.back();
  for (const FactGroup& group : groups_) {
    for (std::size_t i = 0; i < group.size(); ++i) {
      if (facts[group[i]] == 0) continue;
      for (std::size_t j = 0; j < i; ++j) {
        if (facts[group[j]] != 0) clause({-facts[group[i]], -facts[group[j]]});
      }
    }
  }
}

int StepEncoding::begin_at(const Bits& state, std::size_t steps) {
  const int begins = ++last_variable_;
  for (std::size_t fact = 0; fact < problem_.facts.size(); ++fact) {
    const int variable = facts_[steps][fact];
    if (variable != 0) clause({-begins, state.test(fact) ? variable : -variable});
  }
  return begins;
}

std::vector<std::vector<std::size_t>> StepEncoding::plan(std::size_t steps) const {
  std::vector<std::vector<std::size_t>> plan(steps);
  for (std::size_t step = 0; step < steps; ++step) {
    const Layer& actions = actions_[steps - step - 1];
    for (std::size_t action = 0; action < actions.size(); ++action) {
      if (actions[action] != 0 && solver_.val(actions[action]) > 0) plan[step].push_back(action);
    }
  }
  return plan;
}

}  // namespace pizarra::planner
