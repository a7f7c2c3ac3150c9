#include "agents/planner/external/external_plan.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "agents/planner/files/pddl_text.hpp"
#include "agents/planner/task/numbered_task.hpp"

namespace pizarra::planner {

namespace {

pddl_planner::PlanOperators operators_of(const PddlText& text, const PlanningTask& task) {
  pddl_planner::PlanOperators operators;
  for (const auto& [name, known] : text.operators) {
    const auto op = std::ranges::find(task.operators, known.text(), &PlanningOperator::name);
    operators.emplace(name, op->parameters.size());
  }
  return operators;
}

Result<Datum> operation_of(const PddlText& text, const std::vector<std::string>& action) {
  std::vector<Datum> operation{text.operators.at(action.front())};
  for (std::size_t i = 1; i < action.size(); ++i) {
    const auto object = text.objects.find(action[i]);
    if (object == text.objects.end()) {
      return fail("bad-plan", fmt::format("the planner speaks of {}, which is no object", action[i]));
    }
    operation.push_back(object->second);
  }
  return Datum::list(std::move(operation));
}

Result<PlanSteps> steps_of(const PddlText& text, const PlanningTask& task, const pddl_planner::PlanActions& actions) {
  PlanSteps steps;
  for (const std::vector<std::string>& action : actions) {
    const Result<Datum> operation = operation_of(text, action);
    if (!operation) return fail(operation);
    steps.push_back({*operation});
  }
  const Result<void> valid = validate_plan(task, steps);
  if (!valid) {
    return fail("bad-plan", "the planner's plan does not work: " + valid.error().sentence, valid.error().subject);
  }
  return steps;
}

}  // namespace

Result<PlanSteps> plan_externally(const pddl_planner::ExternalPlanner& planner, const PlanningTask& task,
                                  const std::function<bool()>& cancelled) {
  const Result<NumberedTask> checked = number_task(task);
  if (!checked) return fail(checked);
  const PddlText text = pddl_text(task);
  const Result<pddl_planner::PlanClaim> claim =
      planner.plan(text.domain, text.problem, operators_of(text, task), cancelled);
  if (!claim) return fail(claim);
  Result<PlanSteps> steps = steps_of(text, task, claim->actions);
  if (!steps && claim->ended) return fail(*claim->ended);
  return steps;
}

}  // namespace pizarra::planner
