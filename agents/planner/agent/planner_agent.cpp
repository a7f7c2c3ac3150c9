#include "agents/planner/agent/planner_agent.hpp"

#include <atomic>
#include <mutex>
#include <optional>

#include "agents/planner/agent/planner_forms.hpp"
#include "agents/planner/agent/replanner.hpp"
#include "agents/planner/agent/running_plan.hpp"
#include "agents/planner/agent/shortest_way.hpp"
#include "agents/runtime/service.hpp"
#include "blackboard/away.hpp"
#include "blackboard/time/turns.hpp"

namespace pizarra::planner {

namespace {

constexpr std::string_view contract_text = R"(
(contract planner
  (offers
    (get-operations (operators list))
    (get-facts (types list) (initials list) (goals list))
    (get-plan)
    (start-plan)
    (make-plan (n integer) (operators list) (types list) (initials list) (goals list))
    (next-operation (n integer) (holding list))
    (try-plan (operators list) (types list) (initials list) (goals list)))
  (posts (relation planner ((state symbol) (detail datum)) (key))
         (relation plan ((n integer) (operations list)) (key) (durable))
         (relation plan-needs ((n integer) (needs list)) (key) (durable)))
  (reads plan plan-needs)
  (configures get-operations get-facts)
  (monitors planner plan))
)";

constexpr Duration search_cost = 20ms;
// Of a plan that its client did not number.
constexpr std::int64_t unnumbered = 0;

// What one search after another learns. One that was abandoned may not have ended yet when the next begins.
struct SharedReplanner {
  std::mutex in_use;
  Replanner replanner;
};

// One search. The worker may outlive the agent, so it owns what it reads and writes.
struct Search {
  PlanningTask task;
  std::vector<Datum> goals;  // as they were told; the task has none
  std::shared_ptr<SharedReplanner> shared;
  Budget budget;
  std::atomic<bool> abandoned = false;
  Result<ShortestWay> result = ShortestWay{};
};

std::shared_ptr<Search> search_for(std::vector<PlanningOperator> operators, PlanningFacts facts, Budget budget,
                                   std::shared_ptr<SharedReplanner> shared) {
  auto search = std::make_shared<Search>();
  search->task = PlanningTask{std::move(operators), std::move(facts.objects), std::move(facts.initials), {}};
  search->goals = std::move(facts.goals);
  search->budget = budget;
  search->shared = std::move(shared);
  return search;
}

std::function<void(const std::function<bool()>&)> work_of(std::shared_ptr<Search> search) {
  return [search = std::move(search)](const std::function<bool()>& cancelled) {
    const auto stopped = [&] { return search->abandoned || cancelled(); };
    const std::lock_guard<std::mutex> mine(search->shared->in_use);
    search->result = plan_shortest_way(search->shared->replanner, search->task, search->goals, search->budget, stopped);
  };
}

Datum plan_pattern() { return list("plan"_sym, "?"_sym, "?"_sym); }
Datum needs_pattern() { return list("plan-needs"_sym, "?"_sym, "?"_sym); }

}  // namespace

struct PlannerAgent::State {
  State(runtime::AgentContext agent_context, Budget search_budget)
      : context(std::move(agent_context)), budget(search_budget), trying(context.executor) {}

  Task<Result<void>> run();
  Task<Result<Datum>> handle(Datum operation);
  Task<Result<Datum>> get_operations(Datum operators);
  Task<Result<Datum>> get_facts(Datum operation);
  Task<Result<Datum>> get_plan();
  Task<Result<Datum>> start_plan();
  Task<Result<Datum>> make_plan(Datum operation);
  Task<Result<Datum>> next_operation(std::int64_t number, Datum holding);
  Task<Result<Datum>> try_plan(Datum operation);
  // From the operators and facts that were given: the steps.
  Task<Result<Datum>> plan_for(std::int64_t number);
  Task<void> resume();
  Task<void> tell_state(std::string_view state, Datum detail);
  Task<void> tell(Transaction telling);
  void drop_plan();

  runtime::AgentContext context;
  Budget budget;
  const runtime::Service* service = nullptr;  // while run() runs
  std::optional<std::vector<PlanningOperator>> operators;
  std::optional<PlanningFacts> facts;
  std::shared_ptr<Search> search;  // the one under way
  const std::shared_ptr<SharedReplanner> shared = std::make_shared<SharedReplanner>();
  std::optional<RunningPlan> plan;
  bool started = false;
  Turns trying;
};

PlannerAgent::PlannerAgent(runtime::AgentContext context, Budget budget)
    : state_(std::make_unique<State>(std::move(context), budget)) {}

PlannerAgent::~PlannerAgent() = default;

Task<Result<void>> PlannerAgent::run() { return state_->run(); }

Task<Result<void>> PlannerAgent::State::run() {
  Result<runtime::Contract> contract = runtime::contract_from_text(contract_text);
  if (!contract) co_return fail(contract);
  runtime::Service serving(context, std::move(*contract));
  const Result<void> ready = co_await serving.start();
  if (!ready) co_return ready;
  service = &serving;
  co_await resume();
  co_await tell_state("idle", Datum());
  runtime::Handler handler = [this](Datum operation) { return handle(std::move(operation)); };
  const Result<void> served = co_await serving.serve(std::move(handler));
  co_return served;
}

// Goes on with the plan that stands on the board.
Task<void> PlannerAgent::State::resume() {
  const Result<std::vector<Fact>> plans = co_await context.board.facts(plan_pattern());
  const Result<std::vector<Fact>> needs = co_await context.board.facts(needs_pattern());
  if (!plans || !needs || plans->empty() || needs->empty()) co_return;
  Result<RunningPlan> standing = RunningPlan::from_facts(plans->front().datum, needs->front().datum);
  if (!standing) co_return;
  plan = std::move(*standing);
  started = plan->number() != unnumbered;
}

// The state goes with the agent's presence.
Task<void> PlannerAgent::State::tell_state(std::string_view state, Datum detail) {
  Transaction telling;
  telling.tell(list("planner"_sym, Datum::symbol(state), std::move(detail)), {}, service->presence());
  co_await tell(std::move(telling));
}

Task<void> PlannerAgent::State::tell(Transaction telling) {
  Result<Revision> told = co_await context.board.transact(telling);
  while (!told && is_away(told.error())) {
    co_await sleep(context.executor, retry_pause);
    told = co_await context.board.transact(telling);
  }
}

void PlannerAgent::State::drop_plan() {
  if (search) search->abandoned = true;
  search.reset();
  plan.reset();
  started = false;
}

Task<Result<Datum>> PlannerAgent::State::handle(Datum operation) {
  const std::string_view name = operation.head();
  if (name == "get-operations") return get_operations(operation[1]);
  if (name == "get-facts") return get_facts(std::move(operation));
  if (name == "get-plan") return get_plan();
  if (name == "start-plan") return start_plan();
  if (name == "make-plan") return make_plan(std::move(operation));
  if (name == "try-plan") return try_plan(std::move(operation));
  return next_operation(operation[1].integer(), operation[2]);
}

Task<Result<Datum>> PlannerAgent::State::get_operations(Datum forms) {
  Result<std::vector<PlanningOperator>> read = operators_from_list(forms);
  if (!read) co_return fail(as_asked(read.error()));
  operators = std::move(*read);
  drop_plan();
  co_await tell_state("idle", Datum());
  co_return Datum();
}

Task<Result<Datum>> PlannerAgent::State::get_facts(Datum operation) {
  Result<PlanningFacts> read = facts_from_forms(operation[1], operation[2], operation[3]);
  if (!read) co_return fail(read);
  facts = std::move(*read);
  drop_plan();
  co_await tell_state("idle", Datum());
  co_return Datum();
}

Task<Result<Datum>> PlannerAgent::State::get_plan() {
  if (!operators) co_return fail("not-ready", "no operators were given: get-operations comes first");
  if (!facts) co_return fail("not-ready", "no facts were given: get-facts comes first");
  const Result<Datum> steps = co_await plan_for(unnumbered);
  if (!steps) co_return steps;
  co_return list(*steps);
}

Task<Result<Datum>> PlannerAgent::State::make_plan(Datum operation) {
  Result<std::vector<PlanningOperator>> given = operators_from_list(operation[2]);
  if (!given) co_return fail(as_asked(given.error()));
  Result<PlanningFacts> read = facts_from_forms(operation[3], operation[4], operation[5]);
  if (!read) co_return fail(read);
  operators = std::move(*given);
  facts = std::move(*read);
  const Result<Datum> steps = co_await plan_for(operation[1].integer());
  if (!steps) co_return steps;
  started = true;
  co_return list(*steps);
}

Task<Result<Datum>> PlannerAgent::State::plan_for(std::int64_t number) {
  drop_plan();
  const std::shared_ptr<Search> mine = search_for(*operators, *facts, budget, shared);
  search = mine;
  co_await tell_state("planning", Datum::list(facts->goals));
  std::function<void(const std::function<bool()>&)> work = work_of(mine);
  co_await context.executor.offload(std::move(work), search_cost);
  if (search != mine) co_return fail("cancelled", "another plan is wanted now");
  search.reset();
  if (!mine->result) {
    const Failure failure = as_asked(mine->result.error());
    Transaction forgetting;
    forgetting.retract(plan_pattern()).retract(needs_pattern());
    co_await tell(std::move(forgetting));
    co_await tell_state("no-plan", failure_to_datum(failure));
    co_return fail(failure);
  }
  plan.emplace(number, operations_of(mine->result->plan.steps), mine->task.operators, mine->result->literals);
  // A plan that the board cannot keep is carried out all the same, as long as this agent lives.
  Transaction telling;
  for (Datum& fact : plan->facts()) telling.tell(std::move(fact));
  const Datum steps = steps_to_datum(mine->result->plan.steps);
  const Datum engine = Datum::symbol(mine->result->plan.engine);
  const Datum mode = Datum::symbol(name_of(mine->result->plan.mode));
  const Datum detail = list(mode, engine, steps);
  co_await tell(std::move(telling));
  co_await tell_state("planned", detail);
  co_return steps;
}

Task<Result<Datum>> PlannerAgent::State::start_plan() {
  if (!plan) co_return fail("not-ready", "there is no plan to start: get-plan comes first");
  started = true;
  co_return list(plan->operations().empty() ? "done"_sym : plan->operations().front());
}

Task<Result<Datum>> PlannerAgent::State::next_operation(std::int64_t number, Datum holding) {
  const bool runs = plan && started && plan->number() == number;
  if (!runs) co_return fail("not-ready", "no plan of this number runs: make-plan comes first", Datum::integer(number));
  const RunningPlan::Facts facts_now(holding.items().begin(), holding.items().end());
  const std::optional<std::size_t> next = plan->next(facts_now);
  if (!next) co_return fail("off-plan", "no remaining part of the plan fits what holds now", Datum::integer(number));
  co_return plan->from(*next);
}

// Learns nothing from the plan in use, and one at a time, whoever asks.
Task<Result<Datum>> PlannerAgent::State::try_plan(Datum operation) {
  Result<std::vector<PlanningOperator>> given = operators_from_list(operation[1]);
  if (!given) co_return fail(as_asked(given.error()));
  Result<PlanningFacts> read = facts_from_forms(operation[2], operation[3], operation[4]);
  if (!read) co_return fail(read);
  const Turns::Turn turn = co_await trying.take();
  const std::shared_ptr<Search> tried =
      search_for(std::move(*given), std::move(*read), budget, std::make_shared<SharedReplanner>());
  std::function<void(const std::function<bool()>&)> work = work_of(tried);
  co_await context.executor.offload(std::move(work), search_cost);
  if (!tried->result) co_return fail(as_asked(tried->result.error()));
  const Datum steps = steps_to_datum(tried->result->plan.steps);
  co_return list(steps);
}

}  // namespace pizarra::planner
