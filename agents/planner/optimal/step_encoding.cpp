#include "agents/planner/optimal/step_encoding.hpp"

#include <algorithm>

namespace pizarra {

namespace {

bool has(const std::vector<std::size_t>& facts, std::size_t fact) { return std::ranges::binary_search(facts, fact); }

}  // namespace

StepEncoding::StepEncoding(const StepKnowledge& knowledge, std::size_t steps, CaDiCaL::Solver& solver)
    : known_(knowledge),
      steps_(steps),
      solver_(solver),
      adders_(knowledge.problem.facts.size()),
      deleters_(knowledge.problem.facts.size()) {
  for (std::size_t action = 0; action < known_.problem.actions.size(); ++action) {
    for (const std::size_t fact : known_.problem.actions[action].adds) adders_[fact].push_back(action);
    for (const std::size_t fact : known_.problem.actions[action].deletes) deleters_[fact].push_back(action);
  }
  number_variables();
  fix_ends();
  for (std::size_t step = 0; step < steps_; ++step) {
    add_effects(step);
    add_frames(step);
    add_rivals(step);
    add_exclusions(step + 1);
  }
}

// A literal 0 is false, and left out.
void StepEncoding::clause(std::initializer_list<int> literals) {
  for (const int literal : literals) {
    if (literal != 0) solver_.add(literal);
  }
  solver_.add(0);
}

void StepEncoding::number_variables() {
  facts_.assign(steps_ + 1, Layer(known_.problem.facts.size(), 0));
  actions_.assign(steps_, Layer(known_.problem.actions.size(), 0));
  for (std::size_t layer = 0; layer <= steps_; ++layer) {
    Bits present = known_.progression.fact_level(layer).present;
    present &= known_.regression.fact_level(steps_ - layer).present;
    present.for_each([&](std::size_t fact) { facts_[layer][fact] = ++last_variable_; });
  }
  for (std::size_t step = 0; step < steps_; ++step) {
    const Bits& progression = known_.progression.action_level(step + 1).present;
    known_.regression.actions(steps_ - step).for_each([&](std::size_t i) {
      const GroundAction& action = known_.problem.actions[i];
      const bool there =
          progression.test(i) &&
          std::ranges::all_of(action.preconditions, [&](std::size_t fact) { return facts_[step][fact] != 0; }) &&
          std::ranges::all_of(action.adds, [&](std::size_t fact) { return facts_[step + 1][fact] != 0; });
      if (there) actions_[step][i] = ++last_variable_;
    });
  }
}

void StepEncoding::fix_ends() {
  for (std::size_t fact = 0; fact < known_.problem.facts.size(); ++fact) {
    if (known_.problem.initials.test(fact)) clause({facts_.front()[fact]});
    if (known_.problem.goals.test(fact)) clause({facts_.back()[fact]});
  }
}

void StepEncoding::add_effects(std::size_t step) {
  for (std::size_t i = 0; i < known_.problem.actions.size(); ++i) {
    const int variable = actions_[step][i];
    if (variable == 0) continue;
    const GroundAction& action = known_.problem.actions[i];
    for (const std::size_t fact : action.preconditions) {
      clause({-variable, facts_[step][fact]});
      if (!has(action.deletes, fact)) clause({-variable, facts_[step + 1][fact]});
    }
    for (const std::size_t fact : action.adds) clause({-variable, facts_[step + 1][fact]});
    for (const std::size_t fact : action.deletes) {
      if (facts_[step + 1][fact] != 0) clause({-variable, -facts_[step + 1][fact]});
    }
  }
}

void StepEncoding::frame(int literal, int otherwise, const std::vector<std::size_t>& actions, const Layer& step) {
  solver_.add(literal);
  if (otherwise != 0) solver_.add(otherwise);
  for (const std::size_t action : actions) {
    if (step[action] != 0) solver_.add(step[action]);
  }
  solver_.add(0);
}

// A fact changes only because of an action.
void StepEncoding::add_frames(std::size_t step) {
  for (std::size_t fact = 0; fact < known_.problem.facts.size(); ++fact) {
    const int before = facts_[step][fact];
    const int after = facts_[step + 1][fact];
    if (after != 0) frame(-after, before, adders_[fact], actions_[step]);
    if (before != 0) frame(-before, after, deleters_[fact], actions_[step]);
  }
}

// Actions that delete the same fact, one of which needs it, unless facts that exclude each other keep them apart.
void StepEncoding::add_rivals(std::size_t step) {
  const auto kept_apart = [&](const std::vector<std::size_t>& facts, const std::vector<std::size_t>& others) {
    return std::ranges::any_of(facts, [&](std::size_t fact) {
      return std::ranges::any_of(others, [&](std::size_t o) { return known_.exclusions.with(fact).test(o); });
    });
  };
  for (std::size_t fact = 0; fact < known_.problem.facts.size(); ++fact) {
    const std::vector<std::size_t>& deleters = deleters_[fact];
    for (std::size_t i = 0; i < deleters.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        const int a = actions_[step][deleters[i]];
        const int b = actions_[step][deleters[j]];
        const GroundAction& one = known_.problem.actions[deleters[i]];
        const GroundAction& other = known_.problem.actions[deleters[j]];
        if (a == 0 || b == 0 || !(has(one.preconditions, fact) || has(other.preconditions, fact))) continue;
        if (kept_apart(one.preconditions, other.preconditions) || kept_apart(one.adds, other.adds)) continue;
        clause({-a, -b});
      }
    }
  }
}

void StepEncoding::add_exclusions(std::size_t layer) {
  const Layer& facts = facts_[layer];
  for (const FactGroup& group : known_.groups) {
    for (std::size_t i = 0; i < group.size(); ++i) {
      if (facts[group[i]] == 0) continue;
      for (std::size_t j = 0; j < i; ++j) {
        if (facts[group[j]] != 0) clause({-facts[group[i]], -facts[group[j]]});
      }
    }
  }
}

std::vector<std::vector<std::size_t>> StepEncoding::plan() const {
  std::vector<std::vector<std::size_t>> plan(steps_);
  for (std::size_t step = 0; step < steps_; ++step) {
    for (std::size_t action = 0; action < known_.problem.actions.size(); ++action) {
      const int variable = actions_[step][action];
      if (variable != 0 && solver_.val(variable) > 0) plan[step].push_back(action);
    }
  }
  return plan;
}

}  // namespace pizarra
