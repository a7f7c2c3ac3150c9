#include "agents/launcher/judge.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "agents/planner/breadth_first.hpp"

namespace pizarra {

namespace {

// A mark is on the cube's front face, half a cube nearer to the camera than its centre.
constexpr double mark_before_centre_mm = 30;
constexpr double open_gripper_mm = 84;
constexpr double held_gripper_mm = 60;
// A cube's centre is 30 mm above what it stands on, and up to 52 when it stands on a corner.
constexpr double below_table_mm = 0;
constexpr double on_table_mm = 55;
constexpr double higher_than_support_mm = 30;
constexpr double touching_mm = 90;
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

bool is_lost(const Truth::Cube& cube) { return cube.gone || cube.z_mm < below_table_mm; }

double distance_mm(const Truth::Cube& a, const Truth::Cube& b) {
  return std::hypot(a.x_mm - b.x_mm, a.y_mm - b.y_mm, a.z_mm - b.z_mm);
}

// The nearest cube that a loose one can lie on; empty: the table.
std::string support_of(const Truth& truth, const Truth::Cube& loose) {
  std::string support;
  double nearest_mm = touching_mm;
  if (loose.z_mm < on_table_mm) return support;
  for (const auto& [name, cube] : truth.cubes) {
    const bool under = !is_lost(cube) && loose.z_mm - cube.z_mm > higher_than_support_mm && !is_held(truth, name);
    if (!under || distance_mm(loose, cube) >= nearest_mm) continue;
    nearest_mm = distance_mm(loose, cube);
    support = name;
  }
  return support;
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

std::vector<Datum> Judge::declared(std::vector<Datum> facts) const {
  std::erase_if(facts, [&](const Datum& fact) {
    return std::ranges::none_of(domain_.predicates, [&](const Predicate& predicate) {
      return in_small_letters(Datum::symbol(predicate.name)) == Datum::symbol(fact.head());
    });
  });
  return facts;
}

Result<std::vector<Datum>> Judge::facts(const Truth& truth) const {
  const Result<std::vector<Datum>> perceived = perception_.perceive(measured(truth), {});
  if (!perceived) return fail(perceived);
  std::vector<Datum> out = declared(truth.facts);
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

std::vector<Datum> Judge::as_a_person_would_say(const Truth& truth) {
  std::vector<Datum> facts = truth.facts;
  for (const auto& [name, cube] : truth.cubes) {
    if (!cube.loose || is_lost(cube)) continue;
    const std::string support = support_of(truth, cube);
    facts.push_back(support.empty() ? list("on-table"_sym, Datum::symbol(name))
                                    : list("on"_sym, Datum::symbol(name), Datum::symbol(support)));
    facts.push_back(list("clear"_sym, Datum::symbol(name)));
  }
  std::vector<Datum> covered;
  for (const Datum& fact : facts) {
    if (fact.is_form("on")) covered.push_back(list("clear"_sym, fact[2]));
  }
  std::erase_if(facts, [&](const Datum& fact) { return std::ranges::find(covered, fact) != covered.end(); });
  std::ranges::sort(facts);
  return facts;
}

Result<bool> Judge::plan_exists(const std::vector<Datum>& goal, const Truth& truth,
                                const std::vector<Datum>& facts) const {
  PlanningTask task;
  for (const Operator& from : domain_.operators) task.operators.push_back(planning_operator(from));
  for (const auto& [name, cube] : truth.cubes) {
    if (!is_lost(cube)) task.objects.push_back({Datum::symbol(name), perception_.sees()});
  }
  for (const TypedName& object : domain_.objects) {
    task.objects.push_back({in_small_letters(Datum::symbol(object.name)), object.type});
  }
  task.initials = declared(as_a_person_would_say(truth));
  for (const Datum& fact : facts) {
    if (!is_physical(fact)) task.initials.push_back(fact);
  }
  for (const Datum& fact : folded(domain_.facts)) {
    if (!std::ranges::binary_search(facts, fact)) task.initials.push_back(fact);
  }
  task.goals = folded(goal);
  const Result<bool> possible = any_plan(task);
  if (!possible && possible.error().symbol == "unknown-object") return false;
  return possible;
}

}  // namespace pizarra
