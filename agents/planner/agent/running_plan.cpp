#include "agents/planner/agent/running_plan.hpp"

#include <algorithm>

#include "lisp/forms/goal_formula.hpp"
#include "lisp/pattern.hpp"

namespace pizarra::planner {

namespace {

Datum as_list(const RunningPlan::Facts& facts) { return Datum::list({facts.begin(), facts.end()}); }

// The facts that must hold before an operation, so that those that must hold after it do.
RunningPlan::Facts before(const Datum& operation, const PlanningOperator& known, RunningPlan::Facts after) {
  Bindings bindings;
  for (std::size_t i = 0; i < known.parameters.size(); ++i)
    bindings.bind(known.parameters[i].variable, operation[i + 1]);
  for (const Datum& fact : known.adds) after.erase(substitute(fact, bindings));
  for (const Datum& fact : known.deletes) after.erase(list("not"_sym, substitute(fact, bindings)));
  for (const Datum& fact : known.preconditions) after.insert(substitute(fact, bindings));
  return after;
}

}  // namespace

RunningPlan::RunningPlan(std::int64_t number, std::vector<Datum> operations,
                         const std::vector<PlanningOperator>& operators, const std::vector<Datum>& goals)
    : number_(number), operations_(std::move(operations)), needs_(operations_.size() + 1) {
  needs_.back() = Facts(goals.begin(), goals.end());
  for (std::size_t i = operations_.size(); i-- > 0;) {
    const auto known = std::ranges::find(operators, operations_[i].head(), &PlanningOperator::name);
    needs_[i] = before(operations_[i], *known, needs_[i + 1]);
  }
}

Result<RunningPlan> RunningPlan::from_facts(const Datum& plan, const Datum& needs) {
  const bool fits = plan.is_form("plan") && plan.size() == 3 && needs.is_form("plan-needs") && needs.size() == 3 &&
                    plan[1] == needs[1] && needs[2].size() == plan[2].size() + 1;
  if (!fits) return fail("bad-plan", "a plan and what it needs do not fit together", plan);
  RunningPlan out;
  out.number_ = plan[1].integer();
  out.operations_.assign(plan[2].items().begin(), plan[2].items().end());
  for (const Datum& facts : needs[2].items()) out.needs_.emplace_back(facts.items().begin(), facts.items().end());
  return out;
}

std::vector<Datum> RunningPlan::facts() const {
  std::vector<Datum> needs;
  for (const Facts& facts : needs_) needs.push_back(as_list(facts));
  return {list("plan"_sym, number_, Datum::list(operations_)),
          list("plan-needs"_sym, number_, Datum::list(std::move(needs)))};
}

std::optional<std::size_t> RunningPlan::next(const Facts& holding) const {
  for (std::size_t i = needs_.size(); i-- > 0;) {
    const auto is_so = [&](const Datum& literal) { return forms::literal_holds(literal, holding); };
    if (std::ranges::all_of(needs_[i], is_so)) return i;
  }
  return std::nullopt;
}

Datum RunningPlan::from(std::size_t index) const {
  const auto begin = operations_.begin() + static_cast<std::ptrdiff_t>(index);
  const std::size_t after = std::min(index + 1, operations_.size());
  return list(index, Datum::list({begin, operations_.end()}), as_list(needs_[index]), as_list(needs_[after]));
}

}  // namespace pizarra::planner
