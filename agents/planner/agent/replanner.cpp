#include "agents/planner/agent/replanner.hpp"

#include <algorithm>
#include <set>

#include "agents/planner/explanation/fewest_culprits.hpp"
#include "agents/planner/explanation/no_plan.hpp"
#include "agents/planner/task/grounding.hpp"

namespace pizarra::planner {

namespace {

constexpr std::size_t fast_nodes = 50'000;

// Whether the two differ in their initial facts at most.
bool same_but_for_initials(const PlanningTask& a, const PlanningTask& b) {
  return a.operators == b.operators && a.objects == b.objects && a.goals == b.goals && a.types == b.types &&
         a.values == b.values && a.absent_goals == b.absent_goals && a.predicates == b.predicates &&
         a.counts_cost == b.counts_cost;
}

// The predicates of facts that have to be absent for something.
std::set<std::string_view> predicates_of_absents(const PlanningTask& task) {
  std::set<std::string_view> predicates;
  for (const Datum& goal : task.absent_goals) predicates.insert(goal.head());
  for (const PlanningOperator& op : task.operators) {
    for (const Datum& fact : op.absents) predicates.insert(fact.head());
  }
  return predicates;
}

bool is_complement(const Datum& fact) { return fact.is_form("not") && fact.size() == 2 && fact[1].is_list(); }

Outcome plan_of(LastPlan::Steps steps, std::string_view engine) {
  return {.kind = Outcome::Kind::plan, .steps = std::move(steps), .engine = engine};
}

}  // namespace

Replanner::Known::Known(const PlanningTask& for_task, Problem grounded) : task(for_task), problem(std::move(grounded)) {
  if (mode_for(problem) == PlanMode::optimal) search.emplace(problem);
  for (std::size_t i = 0; i < problem.facts.size(); ++i) fact_index.emplace(problem.facts[i], i);
  for (const Datum& fact : task.initials) {
    if (!fact_index.contains(fact)) fixed.push_back(fact);
  }
  std::ranges::sort(fixed);
  possible = problem.initials;
  for (const GroundAction& action : problem.actions) {
    for (const std::size_t fact : action.adds) possible.set(fact);
  }
  // Actions that need such a fact absent were left out where no action takes it away.
  lasting = Bits(problem.facts.size());
  const std::set<std::string_view> absents = predicates_of_absents(task);
  problem.initials.for_each([&](std::size_t fact) {
    const Datum& name = problem.facts[fact];
    if (is_complement(name) || !absents.contains(name.head())) return;
    if (!fact_index.contains(list("not"_sym, name))) lasting.set(fact);
  });
}

// Whether the known problem holds from these facts on too; it then begins with them. It does where all of them could be
// reached from where it was grounded: so can then be whatever can be reached from them.
bool Replanner::begin_from(const std::vector<Datum>& initials) {
  Known& known = *known_;
  Bits begin(known.problem.facts.size());
  for (const auto& [fact, index] : known.fact_index) {
    if (is_complement(fact)) begin.set(index);
  }
  std::vector<Datum> fixed;
  for (const Datum& fact : initials) {
    const auto found = known.fact_index.find(fact);
    if (found != known.fact_index.end()) {
      begin.set(found->second);
    } else {
      fixed.push_back(fact);
    }
    const auto opposite = known.fact_index.find(list("not"_sym, fact));
    if (opposite != known.fact_index.end()) begin.reset(opposite->second);
  }
  std::ranges::sort(fixed);
  if (fixed != known.fixed || !begin.subset_of(known.possible) || !known.lasting.subset_of(begin)) return false;
  known.problem.initials = std::move(begin);
  if (known.search && !known.search->covers(known.problem.initials)) known.search.emplace(known.problem);
  if (known.nearness && !known.nearness->begin_from(known.problem.initials)) known.nearness.reset();
  return true;
}

std::optional<Replanner::Found> Replanner::rest_of_last_plan() const {
  if (!known_->last) return std::nullopt;
  std::optional<LastPlan::Steps> rest = known_->last->rest_from(known_->problem.initials);
  if (!rest) return std::nullopt;
  return Found{plan_of(std::move(*rest), "kept"), known_->last->mode()};
}

Replanner::Found Replanner::search(const Budget& budget, const std::function<bool()>& cancelled) {
  Outcome outcome;
  if (known_->search) outcome = known_->search->run(budget, cancelled);
  if (outcome.kind != Outcome::Kind::gave_up) return {std::move(outcome), PlanMode::optimal};
  Budget less = budget;
  less.nodes = std::min(budget.nodes, fast_nodes);
  Outcome fast = search_fast(less, cancelled);
  if (fast.kind == Outcome::Kind::gave_up && known_->search) return {std::move(outcome), PlanMode::optimal};
  return {std::move(fast), PlanMode::fast};
}

Outcome Replanner::search_fast(const Budget& budget, const std::function<bool()>& caller_cancelled) {
  bool stopped = false;  // for good: what was given up half-way must not be kept
  const std::function<bool()> cancelled = [&] { return stopped = stopped || caller_cancelled(); };
  const Problem& problem = known_->problem;
  if (!known_->nearness) known_->nearness.emplace(problem, cancelled);
  if (stopped) {
    known_->nearness.reset();
    return {.kind = Outcome::Kind::cancelled};
  }
  Nearness& nearness = *known_->nearness;
  if (known_->last) {
    if (const auto plan = known_->last->repaired(nearness.compact, problem.initials)) {
      Outcome outcome = FastPlanner().shorten(problem, nearness, *plan, budget, cancelled);
      outcome.engine = "repaired";
      return outcome;
    }
  }
  return FastPlanner().solve(problem, nearness, budget, cancelled);
}

Result<ReadyPlan> Replanner::plan(const PlanningTask& task, const Budget& budget,
                                  const std::function<bool()>& cancelled) {
  if (!known_ || !same_but_for_initials(known_->task, task) || !begin_from(task.initials)) {
    known_.reset();
    Result<Problem> problem = ground(task, cancelled);
    if (!problem) return fail(problem);
    known_ = std::make_unique<Known>(task, std::move(*problem));
  }
  std::optional<Found> found = rest_of_last_plan();
  if (!found) found = search(budget, cancelled);
  Outcome& outcome = found->outcome;
  if (outcome.kind != Outcome::Kind::plan) {
    blame_fewest(known_->problem, budget, cancelled, outcome);
    return fail(explain(known_->problem, outcome));
  }
  ReadyPlan ready{steps_of(known_->problem, outcome.steps), found->mode, outcome.engine, outcome.nodes};
  const Result<void> valid = validate_plan(task, ready.steps);
  if (!valid) return fail(valid);
  known_->last.emplace(known_->problem, std::move(outcome.steps), found->mode);
  return ready;
}

}  // namespace pizarra::planner
