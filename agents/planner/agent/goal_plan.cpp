#include "agents/planner/agent/goal_plan.hpp"

#include <algorithm>

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

}  // namespace

Result<GoalPlan> plan_goal(Replanner& replanner, PlanningTask task, const std::vector<Datum>& goals,
                           const Budget& budget, const std::function<bool()>& cancelled) {
  Result<std::vector<forms::GoalLiterals>> ways = forms::goal_alternatives(goals, objects_of(task));
  if (!ways) return fail(ways);
  if (ways->empty()) return fail("no-plan", "the goal contradicts itself, whatever is done", goals.front());
  put_nearest_first(*ways, task.initials);
  std::optional<GoalPlan> best;
  std::optional<Failure> why_none;
  for (const forms::GoalLiterals& way : *ways) {
    // Of no objects, everything is so.
    if (way.empty()) return GoalPlan{{.steps = {}, .engine = "kept"}, way};
    Result<ReadyPlan> plan = replanner.plan(with_goals(task, way), budget, cancelled);
    if (!plan) {
      const bool ends = !is_proof(plan.error()) && plan.error().symbol != "gave-up";
      if (ends) return fail(plan);
      // A search that was given up is no proof, whatever was proved of the others.
      if (!why_none || (is_proof(*why_none) && !is_proof(plan.error()))) why_none = plan.error();
      continue;
    }
    const bool shorter = !best || operations_in(plan->steps) < operations_in(best->plan.steps);
    if (shorter) best = GoalPlan{std::move(*plan), way};
    if (operations_in(best->plan.steps) == 0) break;
  }
  if (best) return std::move(*best);
  return fail(*why_none);
}

}  // namespace pizarra::planner
