#include "agents/launcher/judge.hpp"

#include <algorithm>
#include <array>

#include "agents/planner/breadth_first.hpp"

namespace pizarra {

namespace {

// A mark is on the cube's front face, half a cube nearer to the camera than its centre.
constexpr double mark_before_centre_mm = 30;
constexpr double open_gripper_mm = 84;
constexpr double held_gripper_mm = 60;
constexpr std::array<std::string_view, 5> physical{"on", "on-table", "clear", "holding", "arm-empty"};

bool is_physical(const Datum& fact) { return std::ranges::find(physical, fact.head()) != physical.end(); }

bool is_held(const Truth& truth, const std::string& name) {
  return std::ranges::binary_search(truth.facts, list("holding"_sym, Datum::symbol(name)));
}

// The truth as the eyes and the gripper would measure it without any error.
std::vector<Datum> measured(const Truth& truth) {
  std::vector<Datum> out;
  bool held = false;
  for (const auto& [name, cube] : truth.cubes) {
    if (cube.gone) continue;
    const double mark_x_mm = cube.x_mm + mark_before_centre_mm;
    out.push_back(list("seen"_sym, Datum::symbol(name), mark_x_mm, cube.y_mm, cube.z_mm));
    if (!is_held(truth, name)) continue;
    held = true;
    out.push_back(list("grip"_sym, mark_x_mm, cube.y_mm, cube.z_mm));
  }
  out.push_back(list("gripper"_sym, held ? held_gripper_mm : open_gripper_mm));
  return out;
}

std::vector<Datum> folded(const std::vector<Datum>& facts) {
  std::vector<Datum> out;
  for (const Datum& fact : facts) out.push_back(in_small_letters(fact));
  return out;
}

PlanningOperator planning_operator(const Operator& from) {
  PlanningOperator to{from.name, {}, folded(from.preconds), folded(from.adds), folded(from.deletes)};
  for (const TypedName& param : from.params) {
    to.parameters.push_back({std::string(in_small_letters(Datum::symbol(param.name)).text()), param.type});
  }
  return to;
}

}  // namespace

Result<Judge> Judge::make(const Domain& domain) {
  Arities arities;
  for (const Predicate& predicate : domain.predicates) {
    arities.emplace_back(predicate.name, predicate.arguments.size());
  }
  Result<Perception> perception = Perception::read(domain.source, arities);
  if (!perception) return fail(perception);
  return Judge(domain, std::move(*perception));
}

Result<std::vector<Datum>> Judge::facts(const Truth& truth) const {
  const Result<std::vector<Datum>> perceived = perception_.perceive(measured(truth), {});
  if (!perceived) return fail(perceived);
  std::vector<Datum> out;
  for (const Datum& fact : truth.facts) {
    const auto declared = [&](const Predicate& predicate) {
      return in_small_letters(Datum::symbol(predicate.name)) == Datum::symbol(fact.head());
    };
    if (std::ranges::any_of(domain_.predicates, declared)) out.push_back(fact);
  }
  for (const Datum& fact : folded(*perceived)) {
    if (!is_physical(fact)) out.push_back(fact);
  }
  std::ranges::sort(out);
  return out;
}

bool Judge::holds(const std::vector<Datum>& goal, const std::vector<Datum>& facts) {
  return std::ranges::all_of(
      goal, [&](const Datum& fact) { return std::ranges::binary_search(facts, in_small_letters(fact)); });
}

Result<bool> Judge::plan_exists(const std::vector<Datum>& goal, const Truth& truth,
                                const std::vector<Datum>& facts) const {
  PlanningTask task;
  for (const Operator& from : domain_.operators) task.operators.push_back(planning_operator(from));
  for (const auto& [name, cube] : truth.cubes) {
    if (!cube.gone) task.objects.push_back({Datum::symbol(name), perception_.sees()});
  }
  for (const TypedName& object : domain_.objects) {
    task.objects.push_back({in_small_letters(Datum::symbol(object.name)), object.type});
  }
  task.initials = facts;
  for (const Datum& fact : folded(domain_.facts)) {
    if (!std::ranges::binary_search(facts, fact)) task.initials.push_back(fact);
  }
  task.goals = folded(goal);
  const Result<bool> possible = any_plan(task);
  if (!possible && possible.error().symbol == "unknown-object") return false;
  return possible;
}

}  // namespace pizarra
