#include "agents/coordinator/pursue/coordinator_agent.hpp"

#include "agents/coordinator/perceive/role_changes.hpp"
#include "agents/coordinator/pursue/coordinator_contract.hpp"
#include "agents/coordinator/pursue/goal_loop.hpp"
#include "agents/coordinator/pursue/why_not.hpp"
#include "agents/coordinator/retried_commit.hpp"
#include "lisp/forms/goal.hpp"

namespace pizarra::coordinator {

namespace {

std::vector<runtime::Role> roles_of(const CoordinatorOptions& options) {
  std::vector<runtime::Role> roles = {runtime::robot_role(), runtime::eyes_role(), runtime::planner_role()};
  if (options.head) roles.push_back(head_role());
  return roles;
}

// All that exists while the agent serves, each part standing on those before it.
struct Life {
  Life(runtime::AgentContext& context, const CoordinatorOptions& options, TaskDomain task, runtime::Service& service)
      : domain(std::move(task)),
        caller(context, service),
        story(context.board, context.executor),
        roles(context, service, roles_of(options)),
        surroundings(context, options, domain, service, story),
        arm(context, options, roles, caller, story),
        eyes(context, options, roles, caller, surroundings, story),
        head(context, options, roles, caller, surroundings),
        changes(context, roles, surroundings, eyes, story, service),
        planning(context, options, domain, roles, caller, surroundings),
        aims(options, domain, surroundings.scene()),
        carried(context, options, domain, surroundings, arm),
        servo(context, options, service, surroundings, story, arm, eyes, conditions, aims, carried),
        pushes(options, domain, surroundings, story, arm, conditions),
        runner(context, options, domain, surroundings, story, arm, eyes, interruption, conditions, aims, carried, servo,
               pushes),
        rescues(domain, surroundings.scene(), story, arm, pushes, runner, options.gripper.openings.wide_mm),
        survey(options, domain, surroundings, story, arm, eyes, servo, runner, interruption),
        goal(context, story, interruption),
        plan(planning, story),
        differences(surroundings, story),
        head_search(options, domain, surroundings, story, eyes, head, interruption),
        search(context, options, domain, surroundings, story, eyes, head_search, plan, runner, rescues, interruption),
        replanning(context, surroundings, planning, plan, search, runner, rescues, interruption),
        pursuit(context, options, domain, surroundings, story, eyes, planning, plan, differences, search, replanning,
                runner, rescues, survey, interruption, conditions),
        staged(context, surroundings, eyes, plan, goal, pursuit, interruption),
        kept(context, options, surroundings, eyes, planning, differences, goal, staged, interruption),
        loop(plan, goal, staged, kept, interruption),
        why_not(options, domain, surroundings, eyes, planning) {}

  TaskDomain domain;
  runtime::Caller caller;
  Story story;
  runtime::Roles roles;
  Surroundings surroundings;
  Interruption interruption;
  StandingConditions conditions{interruption};
  Arm arm;
  Eyes eyes;
  Head head;
  RoleChanges changes;
  Planning planning;
  Aims aims;
  Carried carried;
  ServoLoop servo;
  Pushes pushes;
  TaskRunner runner;
  Rescues rescues;
  CameraSurvey survey;
  GoalInHand goal;
  PlanInHand plan;
  Differences differences;
  HeadSearch head_search;
  ObjectSearch search;
  Replanning replanning;
  Pursuit pursuit;
  StagedPursuit staged;
  KeptGoal kept;
  GoalLoop loop;
  WhyNot why_not;
  Job changing, pursuing;
};

// The goal of (OPERATION FORM ...), checked.
Task<Result<std::vector<Datum>>> goal_of(Life& life, Datum operation) {
  const Result<std::vector<std::string>> known = co_await life.eyes.objects();
  if (!known) co_return fail(known);
  std::vector<std::pair<std::string, std::string>> objects;
  for (const std::string& name : *known) objects.emplace_back(name, life.domain.perception().sees());
  const std::vector<Datum> wanted(operation.items().begin() + 1, operation.items().end());
  co_return forms::goal_from_data(life.domain.domain(), wanted, objects);
}

Task<Result<Datum>> take_goal(Life& life, Datum operation) {
  Result<std::vector<Datum>> facts = co_await goal_of(life, std::move(operation));
  if (!facts) co_return fail(facts);
  const Result<std::int64_t> number = co_await life.goal.submit(std::move(*facts));
  if (!number) co_return fail(number);
  co_return list(*number);
}

Task<Result<Datum>> take_cancel(Life& life) {
  const Result<void> cancelled = co_await life.goal.cancel();
  if (!cancelled) co_return fail(cancelled);
  co_return Datum();
}

Datum as_texts(const std::vector<std::string>& sentences) {
  std::vector<Datum> told;
  for (const std::string& sentence : sentences) told.push_back(to_datum(sentence));
  return Datum::list(std::move(told));
}

Task<Result<Datum>> tell_why(Life& life) {
  const std::vector<std::string> sentences = co_await life.story.why();
  co_return as_texts(sentences);
}

Task<Result<Datum>> tell_why_not(Life& life, Datum operation) {
  Result<std::vector<Datum>> goal = co_await goal_of(life, std::move(operation));
  if (!goal) co_return fail(goal);
  const Result<std::vector<std::string>> sentences = co_await life.why_not.tell(std::move(*goal));
  if (!sentences) co_return fail(sentences);
  co_return as_texts(*sentences);
}

Task<Result<Datum>> handle(Life& life, Datum operation) {
  if (operation.is_form("goal")) return take_goal(life, std::move(operation));
  if (operation.is_form("cancel")) return take_cancel(life);
  if (operation.is_form("why-not")) return tell_why_not(life, std::move(operation));
  return tell_why(life);
}

}  // namespace

struct CoordinatorAgent::State {
  runtime::AgentContext context;
  CoordinatorOptions options;
};

CoordinatorAgent::CoordinatorAgent(runtime::AgentContext context, CoordinatorOptions options)
    : state_(std::make_unique<State>(std::move(context), std::move(options))) {}

CoordinatorAgent::~CoordinatorAgent() = default;

Task<Result<void>> CoordinatorAgent::run() {
  runtime::AgentContext& context = state_->context;
  Result<TaskDomain> domain = TaskDomain::read(state_->options.domain_file);
  if (!domain) co_return fail(domain);
  if (state_->options.cube_mm) domain->use_cubes(*state_->options.cube_mm, state_->options.edges_mm);
  const std::string text = coordinator_contract(*domain, state_->options.head);
  Result<runtime::Contract> contract = runtime::contract_from_text(text);
  if (!contract) co_return fail(contract);
  // Requests in hand, which the service holds, end before what they work with.
  std::unique_ptr<Life> life;
  runtime::Service service(context, std::move(*contract));
  const Result<void> started = co_await service.start();
  if (!started) co_return started;
  life = std::make_unique<Life>(context, state_->options, std::move(*domain), service);
  co_await life->story.resume();
  co_await life->surroundings.resume();
  co_await life->loop.resume();
  life->roles.start();
  life->surroundings.start();
  life->changing = context.executor.spawn(life->changes.follow());
  life->pursuing = context.executor.spawn(life->loop.run());
  runtime::Handler handler = [&part = *life](Datum operation) { return handle(part, std::move(operation)); };
  const Result<void> served = co_await service.serve(std::move(handler));
  co_return served;
}

}  // namespace pizarra::coordinator
