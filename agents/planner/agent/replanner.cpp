#include "agents/planner/agent/replanner.hpp"

#include <algorithm>

#include "agents/planner/explanation/fewest_culprits.hpp"
#include "agents/planner/explanation/no_plan.hpp"
#include "agents/planner/fast/fast_planner.hpp"
#include "agents/planner/task/grounding.hpp"

namespace pizarra {

namespace {

constexpr std::size_t fast_nodes = 50'000;

// Whether the two differ in their initial facts at most. Where facts must be absent, the problem holds more facts than
// the task speaks of: such tasks are always taken for different.
bool same_but_for_initials(const PlanningTask& a, const PlanningTask& b) {
  const auto simple = [](const PlanningOperator& op) { return op.absents.empty(); };
  return a.operators == b.operators && a.objects == b.objects && a.goals == b.goals && a.types == b.types &&
         a.values == b.values && a.absent_goals.empty() && b.absent_goals.empty() &&
         std::ranges::all_of(a.operators, simple);
}

}  // namespace

Replanner::Known::Known(const PlanningTask& for_task, Problem grounded) : task(for_task), problem(std::move(grounded)) {
  if (mode_for(problem) == PlanMode::optimal) search.emplace(problem);
  for (std::size_t i = 0; i < problem.facts.size(); ++i) fact_index.emplace(problem.facts[i], i);
  for (const Datum& fact : task.initials) {
    if (!fact_index.contains(fact)) fixed.push_back(fact);
  }
  std::ranges::sort(fixed);
}

// Whether the known problem holds from these facts on too; it then begins with them.
bool Replanner::begin_from(const std::vector<Datum>& initials) {
  Bits begin(known_->problem.facts.size());
  std::vector<Datum> fixed;
  for (const Datum& fact : initials) {
    const auto found = known_->fact_index.find(fact);
    if (found != known_->fact_index.end()) {
      begin.set(found->second);
    } else {
      fixed.push_back(fact);
    }
  }
  std::ranges::sort(fixed);
  if (fixed != known_->fixed || !known_->search || !known_->search->covers(begin)) return false;
  known_->problem.initials = std::move(begin);
  return true;
}

// What is left of a shortest plan is a shortest plan.
std::optional<Outcome> Replanner::end_of_last_plan() const {
  const std::vector<Bits>& states = known_->last_states;
  const auto here = std::ranges::find(states, known_->problem.initials);
  if (here == states.end()) return std::nullopt;
  return Outcome{.kind = Outcome::Kind::plan,
                 .steps = {known_->last_steps.begin() + (here - states.begin()), known_->last_steps.end()},
                 .culprits = {},
                 .spent = {},
                 .nodes = 0,
                 .engine = "kept"};
}

Outcome Replanner::search(const Budget& budget, const std::function<bool()>& cancelled) {
  Outcome outcome;
  known_->last_mode = PlanMode::optimal;
  if (known_->search) outcome = known_->search->run(budget, cancelled);
  if (outcome.kind != Outcome::Kind::gave_up) return outcome;
  Budget less = budget;
  less.nodes = std::min(budget.nodes, fast_nodes);
  Outcome fast = FastPlanner().solve(known_->problem, less, cancelled);
  if (fast.kind == Outcome::Kind::gave_up && known_->search) return outcome;
  known_->last_mode = PlanMode::fast;
  return fast;
}

void Replanner::remember(const Outcome& outcome) {
  known_->last_steps = outcome.steps;
  known_->last_states = {known_->problem.initials};
  for (const std::vector<std::size_t>& step : outcome.steps) {
    Bits next = known_->last_states.back();
    for (const std::size_t action : step) next = after(next, known_->problem.actions[action]);
    known_->last_states.push_back(std::move(next));
  }
}

Result<ReadyPlan> Replanner::plan(const PlanningTask& task, const Budget& budget,
                                  const std::function<bool()>& cancelled) {
  if (!known_ || !same_but_for_initials(known_->task, task) || !begin_from(task.initials)) {
    known_.reset();
    Result<Problem> problem = ground(task, cancelled);
    if (!problem) return fail(problem);
    known_ = std::make_unique<Known>(task, std::move(*problem));
  }
  std::optional<Outcome> outcome = end_of_last_plan();
  if (!outcome) outcome = search(budget, cancelled);
  if (outcome->kind != Outcome::Kind::plan) {
    blame_fewest(known_->problem, budget, cancelled, *outcome);
    return fail(explain(known_->problem, *outcome));
  }
  ReadyPlan ready{steps_of(known_->problem, outcome->steps), known_->last_mode, outcome->engine, outcome->nodes};
  const Result<void> valid = validate_plan(task, ready.steps);
  if (!valid) return fail(valid);
  remember(*outcome);
  return ready;
}

}  // namespace pizarra
