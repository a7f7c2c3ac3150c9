#include <algorithm>
#include <fmt/format.h>
#include <optional>
#include <set>

#include "agents/planner/task/planning_task.hpp"
#include "lisp/pattern.hpp"
#include "lisp/writer.hpp"

namespace pizarra::planner {

namespace {

// One operation of a plan with its variables replaced. What it adds is not among what it deletes.
struct Effects {
  std::vector<Datum> preconditions;
  std::vector<Datum> absents;
  std::vector<Datum> adds;
  std::vector<Datum> deletes;
};

bool contains(const std::vector<Datum>& facts, const Datum& fact) {
  return std::ranges::find(facts, fact) != facts.end();
}

std::vector<Datum> substituted(const std::vector<Datum>& atoms, const Bindings& bindings) {
  std::vector<Datum> facts;
  for (const Datum& atom : atoms) facts.push_back(substitute(atom, bindings));
  return facts;
}

// The operation's operator and what its parameters stand for.
struct Instance {
  const PlanningOperator& source;
  Bindings bindings;
};

Result<Instance> instance_of(const PlanningTask& task, const Datum& operation) {
  const auto found = std::ranges::find(task.operators, operation.head(), &PlanningOperator::name);
  if (found == task.operators.end() || operation.size() != found->parameters.size() + 1) {
    return fail("bad-plan", write(operation) + " is no operation of the domain", operation);
  }
  Instance instance{*found, {}};
  for (std::size_t i = 0; i < found->parameters.size(); ++i) {
    const PlanningParameter& parameter = found->parameters[i];
    const auto object = std::ranges::find(task.objects, operation[i + 1], &PlanningObject::name);
    if (object == task.objects.end() || !is_subtype(task.types, object->type, parameter.type)) {
      return fail("bad-plan",
                  fmt::format("{} in {} is no {}", write(operation[i + 1]), write(operation), parameter.type),
                  operation);
    }
    instance.bindings.bind(parameter.variable, operation[i + 1]);
  }
  return instance;
}

// None where a function of it has no value.
std::optional<std::int64_t> cost_of(const PlanningTask& task, const Instance& instance) {
  if (!task.counts_cost) return 1;
  std::int64_t sum = 0;
  for (const Datum& cost : instance.source.costs) {
    const auto value = task.values.find(substitute(cost, instance.bindings));
    if (!cost.is_integer() && value == task.values.end()) return std::nullopt;
    sum += cost.is_integer() ? cost.integer() : value->second;
  }
  return sum;
}

Result<Effects> effects_of(const PlanningTask& task, const Datum& operation) {
  const Result<Instance> instance = instance_of(task, operation);
  if (!instance) return fail(instance);
  const auto& [source, bindings] = *instance;
  for (const PlanningEquality& equality : source.equalities) {
    if ((substitute(equality.left, bindings) == substitute(equality.right, bindings)) == equality.equal) continue;
    return fail("bad-plan",
                fmt::format("{} needs {} and {} to be {}", write(operation), write(equality.left),
                            write(equality.right), equality.equal ? "the same" : "different"),
                operation);
  }
  if (!cost_of(task, *instance)) {
    return fail("bad-plan", fmt::format("the cost of {} is not defined", write(operation)), operation);
  }
  Effects effects{substituted(source.preconditions, bindings), substituted(source.absents, bindings),
                  substituted(source.adds, bindings), substituted(source.deletes, bindings)};
  std::erase_if(effects.deletes, [&](const Datum& fact) { return contains(effects.adds, fact); });
  return effects;
}

bool spoils(const Effects& by, const Effects& of) {
  const auto needed_or_made = [&](const Datum& fact) {
    return contains(of.preconditions, fact) || contains(of.adds, fact);
  };
  const auto needed_absent = [&](const Datum& fact) { return contains(of.absents, fact); };
  return std::ranges::any_of(by.deletes, needed_or_made) || std::ranges::any_of(by.adds, needed_absent);
}

Result<void> replay_step(const PlanningTask& task, const std::vector<Datum>& step, std::set<Datum>& state) {
  std::vector<Effects> all;
  for (const Datum& operation : step) {
    Result<Effects> effects = effects_of(task, operation);
    if (!effects) return fail(effects);
    for (const Datum& fact : effects->preconditions) {
      if (!state.contains(fact)) {
        return fail("bad-plan", fmt::format("{} needs {}, which does not hold", write(operation), write(fact)),
                    operation);
      }
    }
    for (const Datum& fact : effects->absents) {
      if (state.contains(fact)) {
        return fail("bad-plan", fmt::format("{} needs {} not to hold", write(operation), write(fact)), operation);
      }
    }
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (!spoils(all[i], *effects) && !spoils(*effects, all[i])) continue;
      return fail("bad-plan", fmt::format("{} and {} interfere in one step", write(step[i]), write(operation)),
                  list(step[i], operation));
    }
    all.push_back(std::move(*effects));
  }
  for (const Effects& effects : all) {
    for (const Datum& fact : effects.deletes) state.erase(fact);
    state.insert(effects.adds.begin(), effects.adds.end());
  }
  return {};
}

}  // namespace

std::int64_t plan_cost(const PlanningTask& task, const PlanSteps& steps) {
  std::int64_t cost = 0;
  for (const std::vector<Datum>& step : steps) {
    for (const Datum& operation : step) {
      const Result<Instance> instance = instance_of(task, operation);
      if (instance) cost += cost_of(task, *instance).value_or(0);
    }
  }
  return cost;
}

Result<void> validate_plan(const PlanningTask& task, const PlanSteps& steps) {
  std::set<Datum> state(task.initials.begin(), task.initials.end());
  for (const std::vector<Datum>& step : steps) {
    const Result<void> replayed = replay_step(task, step, state);
    if (!replayed) return replayed;
  }
  for (const Datum& goal : task.goals) {
    if (!state.contains(goal)) return fail("bad-plan", write(goal) + " is not reached", goal);
  }
  for (const Datum& goal : task.absent_goals) {
    if (state.contains(goal)) return fail("bad-plan", write(goal) + " holds in the end", goal);
  }
  return {};
}

}  // namespace pizarra::planner
