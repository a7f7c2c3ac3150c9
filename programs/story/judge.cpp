#include "programs/story/judge.hpp"

#include <algorithm>
#include <cmath>

#include "agents/coordinator/pursue/staged_goal.hpp"
#include "agents/planner/judge/breadth_first.hpp"

namespace pizarra::story {

namespace {

// Wider than any cube.
constexpr double open_gripper_mm = 100;
constexpr double below_table_mm = 0;
// In cubes. The middle is half a cube above what it stands on, and 0.87 when it stands on a corner.
constexpr double on_table = 0.92;
constexpr double higher_than_support = 0.5;
constexpr double touching = 1.5;

bool is_lost(const WorldState::Cube& cube) { return cube.gone || cube.z_mm < below_table_mm; }

// Neither it nor what it stands on leans, falls or is carried.
bool is_firm(const WorldState& truth, const WorldState::Cube& cube) {
  const auto below = truth.cubes.find(cube.on);
  return !cube.loose && (below == truth.cubes.end() || is_firm(truth, below->second));
}

double distance_mm(const WorldState::Cube& a, const WorldState::Cube& b) {
  return std::hypot(a.x_mm - b.x_mm, a.y_mm - b.y_mm, a.z_mm - b.z_mm);
}

std::vector<Datum> folded(const std::vector<Datum>& facts) {
  std::vector<Datum> out;
  for (const Datum& fact : facts) out.push_back(in_small_letters(fact));
  return out;
}

// The facts that the goal wants in the end, with names spelled as the world does; types keep their spelling.
std::vector<Datum> wanted_in_the_end(const std::vector<Datum>& goal) {
  std::vector<Datum> normal;
  for (const Datum& form : goal) normal.push_back(forms::without_variables(form));
  const coordinator::StagedGoal staged = coordinator::staged_goal_of(normal);
  if (staged.stages.empty()) return {};
  return staged.stages.back();
}

Datum named_small(const Datum& form) {
  const bool typed = form.is_form("forall") || form.is_form("exists") || form.is_form("at-least");
  if (!typed) {
    const bool joins = form.is_form("and") || form.is_form("or") || form.is_form("not");
    if (!joins) return in_small_letters(form);
    std::vector<Datum> parts{form[0]};
    for (const Datum& part : form.items().subspan(1)) parts.push_back(named_small(part));
    return Datum::list(std::move(parts));
  }
  std::vector<Datum> parts(form.items().begin(), form.items().end());
  Datum& declared = parts[parts.size() - 2];
  declared = list(in_small_letters(declared[0]), declared[1]);
  parts.back() = named_small(parts.back());
  return Datum::list(std::move(parts));
}

std::vector<Datum> named_small(const std::vector<Datum>& goal) {
  std::vector<Datum> out;
  for (const Datum& form : goal) out.push_back(named_small(form));
  return out;
}

planner::PlanningOperator planning_operator(const forms::Operator& from) {
  planner::PlanningOperator to{from.name, {}, folded(from.preconds), folded(from.adds), folded(from.deletes)};
  for (const forms::TypedName& param : from.params) {
    to.parameters.push_back({std::string(in_small_letters(Datum::symbol(param.name)).text()), param.type});
  }
  return to;
}

}  // namespace

Result<Judge> Judge::make(const forms::Domain& domain, double cube_mm, const forms::EdgesMm& edges_mm) {
  forms::Arities arities;
  for (const forms::Predicate& predicate : domain.predicates) {
    arities.emplace_back(predicate.name, predicate.arguments.size());
  }
  Result<forms::Perception> perception = forms::Perception::read(domain.source, arities);
  if (!perception) return fail(perception);
  perception->set_constant("cube", cube_mm);
  forms::EdgesMm small;
  for (const auto& [name, edge_mm] : edges_mm) {
    small.emplace(in_small_letters(Datum::symbol(name)).text(), edge_mm);
  }
  perception->set_edges(small);
  return Judge(domain, std::move(*perception), cube_mm, std::move(small));
}

double Judge::edge_mm(const std::string& name) const {
  const auto known = edges_mm_.find(name);
  return known == edges_mm_.end() ? cube_mm_ : known->second;
}

// As the eyes and the gripper would measure it without any error: a mark is on the cube's front face.
std::vector<Datum> Judge::measured(const WorldState& truth) const {
  std::vector<Datum> out;
  double opening_mm = open_gripper_mm;
  for (const auto& [name, cube] : truth.cubes) {
    if (cube.gone || !is_firm(truth, cube)) continue;
    const double mark_x_mm = cube.x_mm + edge_mm(name) / 2;
    out.push_back(list("seen"_sym, Datum::symbol(name), mark_x_mm, cube.y_mm, cube.z_mm));
    if (!cube.held) continue;
    opening_mm = edge_mm(name);
    out.push_back(list("grip"_sym, mark_x_mm, cube.y_mm, cube.z_mm));
  }
  out.push_back(list("gripper"_sym, opening_mm));
  return out;
}

Result<std::vector<Datum>> Judge::facts(const WorldState& truth) const {
  const Result<std::vector<Datum>> perceived = perception_.perceive(measured(truth), {});
  if (!perceived) return perceived;
  std::vector<Datum> out;
  for (const Datum& fact : *perceived) {
    if (domain_.find_predicate(fact.head())) out.push_back(in_small_letters(fact));
  }
  std::ranges::sort(out);
  return out;
}

bool Judge::holds(const std::vector<Datum>& goal, const std::vector<Datum>& facts) {
  return std::ranges::all_of(
      goal, [&](const Datum& fact) { return std::ranges::binary_search(facts, in_small_letters(fact)); });
}

forms::TypedObjects Judge::objects(const WorldState& truth) const {
  forms::TypedObjects objects;
  for (const auto& [name, cube] : truth.cubes) {
    if (!is_lost(cube)) objects.emplace_back(name, perception_.sees());
  }
  for (const forms::TypedName& object : domain_.objects) {
    objects.emplace_back(in_small_letters(Datum::symbol(object.name)).text(), object.type);
  }
  return objects;
}

Result<bool> Judge::shows(const std::vector<Datum>& goal, const WorldState& truth) const {
  const Result<std::vector<Datum>> found = facts(truth);
  if (!found) return fail(found);
  std::set<Datum> holding(found->begin(), found->end());
  for (const Datum& fact : folded(domain_.facts)) holding.insert(fact);
  return forms::goal_holds(named_small(wanted_in_the_end(goal)), holding, objects(truth));
}

// The nearest cube that a loose one can lie on; empty: the table.
std::string Judge::support_of(const WorldState& truth, const WorldState::Cube& loose) const {
  std::string support;
  double nearest_mm = touching * cube_mm_;
  if (loose.z_mm < on_table * cube_mm_) return support;
  for (const auto& [name, cube] : truth.cubes) {
    const bool under = !is_lost(cube) && loose.z_mm - cube.z_mm > higher_than_support * cube_mm_ && !cube.held;
    if (!under || distance_mm(loose, cube) >= nearest_mm) continue;
    nearest_mm = distance_mm(loose, cube);
    support = name;
  }
  return support;
}

// Every cube that is loose put squarely where it lies, the lowest first: others may lie on it.
WorldState Judge::squared(WorldState truth) const {
  std::vector<std::pair<double, std::string>> by_height;
  for (const auto& [name, cube] : truth.cubes) {
    if (!is_lost(cube)) by_height.emplace_back(cube.z_mm, name);
  }
  std::ranges::sort(by_height);
  const WorldState as_it_lies = truth;
  for (const auto& [height, name] : by_height) {
    WorldState::Cube& cube = truth.cubes.at(name);
    const std::string support = cube.loose ? support_of(as_it_lies, cube) : cube.on;
    if (support.empty() && !cube.loose) continue;
    if (support.empty()) {
      cube.z_mm = edge_mm(name) / 2;
    } else {
      const WorldState::Cube& below = truth.cubes.at(support);
      if (cube.loose) cube.x_mm = below.x_mm;
      if (cube.loose) cube.y_mm = below.y_mm;
      cube.z_mm = below.z_mm + (edge_mm(support) + edge_mm(name)) / 2;
    }
    cube.on = support;
    cube.loose = false;
  }
  return truth;
}

Result<std::vector<Datum>> Judge::as_a_person_would_say(const WorldState& truth) const { return facts(squared(truth)); }

Result<bool> Judge::plan_exists(const std::vector<Datum>& goal, const WorldState& truth) const {
  const Result<std::vector<Datum>> said = as_a_person_would_say(truth);
  if (!said) return fail(said);
  planner::PlanningTask task;
  for (const forms::Operator& from : domain_.operators) task.operators.push_back(planning_operator(from));
  for (const auto& [name, type] : objects(truth)) task.objects.push_back({Datum::symbol(name), type});
  task.initials = *said;
  for (const Datum& fact : folded(domain_.facts)) {
    if (!std::ranges::binary_search(*said, fact)) task.initials.push_back(fact);
  }
  const Result<std::vector<forms::GoalLiterals>> ways =
      forms::goal_alternatives(named_small(wanted_in_the_end(goal)), objects(truth));
  if (!ways) return fail(ways);
  for (const forms::GoalLiterals& way : *ways) {
    task.goals.clear();
    task.absent_goals.clear();
    for (const Datum& literal : way) {
      if (literal.is_form("not")) task.absent_goals.push_back(literal[1]);
      if (!literal.is_form("not")) task.goals.push_back(literal);
    }
    const Result<bool> possible = planner::any_plan(task);
    if (!possible && possible.error().symbol != "unknown-object") return possible;
    if (possible && *possible) return true;
  }
  return false;
}

}  // namespace pizarra::story
