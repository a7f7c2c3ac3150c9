#include "agents/planner/agent/shortest_way.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace pizarra::planner {

namespace {

std::size_t operations_in(const PlanSteps& steps) {
  std::size_t count = 0;
  for (const std::vector<Datum>& step : steps) count += step.size();
  return count;
}

forms::TypedObjects objects_of(const PlanningTask& task) {
  forms::TypedObjects objects;
  for (const PlanningObject& object : task.objects) {
    if (object.name.is_symbol()) objects.emplace_back(object.name.text(), object.type);
  }
  return objects;
}

// Those first of which most holds already: a plan of nothing at all ends the search.
void put_nearest_first(std::vector<forms::GoalLiterals>& ways, const std::vector<Datum>& initials) {
  const std::set<Datum> holding(initials.begin(), initials.end());
  const auto missing = [&](const forms::GoalLiterals& way) {
    return std::ranges::count_if(way, [&](const Datum& literal) { return !forms::literal_holds(literal, holding); });
  };
  std::ranges::stable_sort(ways, {}, missing);
}

PlanningTask with_goals(const PlanningTask& task, const forms::GoalLiterals& literals) {
  PlanningTask out = task;
  for (const Datum& literal : literals) {
    if (literal.is_form("not")) {
      out.absent_goals.push_back(literal[1]);
    } else {
      out.goals.push_back(literal);
    }
  }
  return out;
}

bool is_proof(const Failure& failure) { return failure.symbol == "no-plan"; }

Failure without_a_way(const std::vector<Datum>& goals, const forms::TypedObjects& objects) {
  const std::optional<forms::TooFewObjects> few = forms::too_few_objects(goals, objects);
  if (!few) return {"no-plan", "the goal contradicts itself, whatever is done", goals.front(), {}};
  const std::string there = few->there == 0 ? "there is none" : fmt::format("there are only {}", few->there);
  const std::string sentence = fmt::format("the goal wants {} of the type {}, and {}", few->wanted, few->type, there);
  return {"no-plan", sentence, few->part, {}};
}

// Whether a failure says more of a goal with several ways than another. A search that was given up is no proof,
// whatever was proved of the others. Facts that exclude each other say more than one that never holds, as (on a a): a
// quantifier brings such a fact into ways that nobody thinks of.
bool says_more(const Failure& failure, const Failure& than) {
  if (!is_proof(than)) return false;
  return !is_proof(failure) || failure.subject.items().size() > than.subject.items().size();
}

// The failure of one way as an example of all.
Failure of_all(Failure failure, std::size_t ways) {
  constexpr std::string_view none = "no plan exists: ";
  if (ways < 2 || !failure.sentence.starts_with(none)) return failure;
  failure.sentence = fmt::format("none of {} ways has a plan; of one, {}", ways, failure.sentence.substr(none.size()));
  return failure;
}

}  // namespace

Result<ShortestWay> plan_shortest_way(Replanner& replanner, PlanningTask task, const std::vector<Datum>& goals,
                                      const Budget& budget, const std::function<bool()>& cancelled) {
  Result<std::vector<forms::GoalLiterals>> ways = forms::goal_alternatives(goals, objects_of(task));
  if (!ways) return fail(ways);
  if (ways->empty()) return std::unexpected(without_a_way(goals, objects_of(task)));
  put_nearest_first(*ways, task.initials);
  std::optional<ShortestWay> best;
  std::optional<Failure> why_none;
  for (const forms::GoalLiterals& way : *ways) {
    // Of no objects, everything is so.
    if (way.empty()) return ShortestWay{{.steps = {}, .engine = "kept"}, way};
    Result<ReadyPlan> plan = replanner.plan(with_goals(task, way), budget, cancelled);
    if (!plan) {
      const bool ends = !is_proof(plan.error()) && plan.error().symbol != "gave-up";
      if (ends) return fail(plan);
      if (!why_none || says_more(plan.error(), *why_none)) why_none = plan.error();
      continue;
    }
    const bool shorter = !best || operations_in(plan->steps) < operations_in(best->plan.steps);
    if (shorter) best = ShortestWay{std::move(*plan), way};
    if (operations_in(best->plan.steps) == 0) break;
  }
  if (best) return std::move(*best);
  return std::unexpected(of_all(std::move(*why_none), ways->size()));
}

}  // namespace pizarra::planner
