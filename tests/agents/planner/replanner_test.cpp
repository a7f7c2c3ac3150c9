#include "agents/planner/agent/replanner.hpp"

#include <algorithm>
#include <ctime>

#include "agents/planner/optimal/optimal_planner.hpp"
#include "agents/planner/task/grounding.hpp"
#include "tests/agents/planner/engine_contract.hpp"

namespace pizarra {
namespace {

struct Fresh {
  std::optional<std::size_t> steps;  // none: there is no plan
  std::size_t nodes = 0;
};

Fresh plan_anew(const PlanningTask& task) {
  const Result<Problem> problem = ground(task);
  const Outcome outcome = OptimalPlanner().solve(*problem, {}, never);
  if (outcome.kind != Outcome::Kind::plan) return {std::nullopt, outcome.nodes};
  return {outcome.steps.size(), outcome.nodes};
}

std::vector<Datum> facts_that_hold(const Problem& problem, const Bits& state) {
  std::vector<Datum> facts;
  state.for_each([&](std::size_t fact) {
    if (!problem.facts[fact].is_form("not")) facts.push_back(problem.facts[fact]);
  });
  return facts;
}

// The task as it is after some action that could be taken, as if a hand had done it.
void meddle(PlanningTask& task, Random& random) {
  const Result<Problem> problem = ground(task);
  std::vector<std::size_t> possible;
  for (std::size_t i = 0; i < problem->actions.size(); ++i) {
    if (applicable(problem->actions[i], problem->initials)) possible.push_back(i);
  }
  if (possible.empty()) return;
  const GroundAction& action = problem->actions[possible[random.below(possible.size())]];
  std::vector<Datum> fixed;  // what no action changes
  std::ranges::copy_if(task.initials, std::back_inserter(fixed), [&](const Datum& fact) {
    return std::ranges::find(problem->facts, fact) == problem->facts.end();
  });
  task.initials = facts_that_hold(*problem, after(problem->initials, action));
  task.initials.insert(task.initials.end(), fixed.begin(), fixed.end());
}

// Whatever the planner planned before.
std::size_t expect_shortest(Replanner& replanner, const PlanningTask& task) {
  const Result<ReadyPlan> plan = replanner.plan(task, {}, never);
  const Fresh fresh = plan_anew(task);
  if (!fresh.steps) {
    EXPECT_EQ(plan ? "a plan" : plan.error().symbol, "no-plan");
    return 0;
  }
  EXPECT_TRUE(plan) << plan.error().sentence;
  if (!plan) return 0;
  EXPECT_EQ(plan->steps.size(), *fresh.steps) << plan->engine;
  const Result<void> valid = validate_plan(task, plan->steps);
  EXPECT_TRUE(valid) << valid.error().sentence;
  return plan->nodes;
}

template <class Make>
void expect_shortest_while_the_world_changes(std::uint64_t seeds, Make make) {
  for (std::uint64_t seed = 1; seed <= seeds && !testing::Test::HasFailure(); ++seed) {
    Random random(seed);
    PlanningTask task = make(random);
    Replanner replanner;
    for (int change = 0; change < 8; ++change) {
      SCOPED_TRACE(fmt::format("seed {}, change {}: {}", seed, change, show(task)));
      expect_shortest(replanner, task);
      meddle(task, random);
      if (random.below(4) == 0 && task.goals.size() > 1) task.goals.pop_back();
      if (random.below(6) == 0) task.goals = make(random).goals;
    }
  }
}

TEST(Replanner, PlansAsShortlyAsFromTheStartWhateverHasChanged) {
  expect_shortest_while_the_world_changes(60, [](Random& random) { return random_blocks(5, random); });
  expect_shortest_while_the_world_changes(30, random_logistics);
  expect_shortest_while_the_world_changes(30, random_gripper);
  expect_shortest_while_the_world_changes(300, random_nonsense);
}

TEST(Replanner, PlansWhereFactsMustBeAbsentAsIfForTheFirstTime) {
  expect_shortest_while_the_world_changes(60, random_conditions);
}

TEST(Replanner, TakesWhatIsLeftOfItsPlanWhereTheWorldFollowsIt) {
  Random random(4);
  PlanningTask task = random_blocks(6, random);
  Replanner replanner;
  const Result<ReadyPlan> whole = replanner.plan(task, {}, never);
  ASSERT_TRUE(whole);
  ASSERT_GT(whole->steps.size(), 2u);
  const Result<Problem> problem = ground(task);
  Bits state = problem->initials;
  for (std::size_t step = 0; step < 2; ++step) {
    const auto done = std::ranges::find(problem->actions, whole->steps[step][0], &GroundAction::name);
    state = after(state, *done);
  }
  task.initials = facts_that_hold(*problem, state);
  const Result<ReadyPlan> rest = replanner.plan(task, {}, never);
  ASSERT_TRUE(rest);
  EXPECT_EQ(rest->engine, "kept");
  EXPECT_EQ(rest->nodes, 0u);
  EXPECT_EQ(rest->steps, PlanSteps(whole->steps.begin() + 2, whole->steps.end()));
}

TEST(Replanner, WorksLessForAChangedFactThanForPlanningAnew) {
  std::size_t again = 0;
  std::size_t anew = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Random random(seed);
    PlanningTask task = random_blocks(4 + random.below(3), random);
    Replanner replanner;
    expect_shortest(replanner, task);
    meddle(task, random);
    SCOPED_TRACE(fmt::format("seed {}: {}", seed, show(task)));
    const std::size_t nodes = expect_shortest(replanner, task);
    const std::size_t fresh = plan_anew(task).nodes;
    EXPECT_LE(nodes, fresh);
    again += nodes;
    anew += fresh;
  }
  EXPECT_LT(2 * again, anew);
}

std::clock_t cpu_of(const std::function<void()>& work) {
  const std::clock_t begin = std::clock();
  work();
  return std::clock() - begin;
}

TEST(Replanner, EndsBeforeAllIsGroundedWhereItIsCancelled) {
  Random random(7);
  const PlanningTask task = random_blocks(150, random);
  const std::clock_t whole = cpu_of([&] { EXPECT_TRUE(ground(task)); });
  const std::clock_t cancelled = cpu_of([&] {
    const Result<ReadyPlan> plan = Replanner().plan(task, {}, [] { return true; });
    EXPECT_EQ(plan ? "a plan" : plan.error().symbol, "cancelled");
  });
  EXPECT_LT(4 * cancelled, whole);
}

TEST(Replanner, PlansFastWhereAShortestPlanWouldTakeTooLong) {
  Random random(60);
  const PlanningTask task = random_blocks(60, random);
  Replanner replanner;
  const Result<ReadyPlan> plan = replanner.plan(task, {.nodes = 20'000}, never);
  ASSERT_TRUE(plan) << plan.error().sentence;
  EXPECT_EQ(plan->mode, PlanMode::fast);
  EXPECT_TRUE(validate_plan(task, plan->steps));
}

}  // namespace
}  // namespace pizarra
