#include "agents/planner/agent/replanner.hpp"

#include <algorithm>
#include <ctime>

#include "agents/planner/optimal/optimal_search.hpp"
#include "agents/planner/task/grounding.hpp"
#include "tests/agents/planner/engine_contract.hpp"

namespace pizarra::planner {
namespace {

struct Fresh {
  std::optional<std::size_t> steps;  // none: there is no plan
  std::size_t nodes = 0;
};

Fresh plan_anew(const PlanningTask& task) {
  const Result<Problem> problem = ground(task);
  if (!problem) return {};
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
    // The latter where neither an operator nor, any more, an initial fact speaks of a goal.
    const std::string said = plan ? "a plan" : plan.error().symbol;
    EXPECT_TRUE(said == "no-plan" || said == "unknown-predicate") << said;
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

// What holds after the first step of a plan.
void take_first_step(PlanningTask& task, const PlanSteps& steps) {
  const Result<Problem> problem = ground(task);
  Bits state = problem->initials;
  for (const Datum& operation : steps.at(0)) {
    state = after(state, *std::ranges::find(problem->actions, operation, &GroundAction::name));
  }
  task.initials = facts_that_hold(*problem, state);
}

TEST(Replanner, TakesWhatIsLeftOfAPlanMadeFast) {
  Random random(60);
  PlanningTask task = random_blocks(60, random);
  Replanner replanner;
  const Result<ReadyPlan> whole = replanner.plan(task, {.nodes = 20'000}, never);
  ASSERT_TRUE(whole) << whole.error().sentence;
  take_first_step(task, whole->steps);
  const Result<ReadyPlan> rest = replanner.plan(task, {.nodes = 20'000}, never);
  ASSERT_TRUE(rest) << rest.error().sentence;
  EXPECT_EQ(rest->mode, PlanMode::fast);
  EXPECT_EQ(rest->engine, "kept");
  EXPECT_EQ(rest->steps, PlanSteps(whole->steps.begin() + 1, whole->steps.end()));
}

TEST(Replanner, RepairsAPlanMadeFastWithAFractionOfTheWork) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    Random random(seed);
    PlanningTask task = random_blocks(42, random);
    Replanner replanner;
    const Budget budget{.nodes = 20'000};
    Result<ReadyPlan> before = replanner.plan(task, budget, never);
    for (int change = 0; change < 4; ++change) {
      SCOPED_TRACE(fmt::format("seed {}, change {}", seed, change));
      ASSERT_TRUE(before) << before.error().sentence;
      meddle(task, random);
      const Result<ReadyPlan> now = replanner.plan(task, budget, never);
      ASSERT_TRUE(now) << now.error().sentence;
      EXPECT_EQ(now->mode, PlanMode::fast);
      EXPECT_TRUE(now->engine == "kept" || now->engine == "repaired") << now->engine;
      EXPECT_TRUE(validate_plan(task, now->steps));
      EXPECT_LE(now->steps.size(), before->steps.size() + 1);  // what was done can be undone
      before = now;
    }
  }
}

TEST(Replanner, SaysAsIfForTheFirstTimeThatNoPlanCanBeMadeFastAnyMore) {
  Random random(5);
  PlanningTask task = random_blocks(42, random);
  Replanner replanner;
  ASSERT_TRUE(replanner.plan(task, {.nodes = 5000}, never));
  const std::vector<Datum> initials = task.initials;
  std::erase(task.initials, form("(arm-empty)"));
  const Result<ReadyPlan> none = replanner.plan(task, {.nodes = 5000}, never);
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().symbol, Replanner().plan(task, {.nodes = 5000}, never).error().symbol);
  task.initials = initials;
  const Result<ReadyPlan> again = replanner.plan(task, {.nodes = 5000}, never);
  ASSERT_TRUE(again) << again.error().sentence;
  EXPECT_EQ(again->engine, "kept");
}

TEST(Replanner, TakesWhatIsLeftOfItsPlanWhereFactsMustBeAbsent) {
  Random random(4);
  PlanningTask task = random_blocks(6, random);
  for (PlanningOperator& op : task.operators) op.absents = {form("(jammed)")};
  task.operators.push_back({"JAM", {}, {form("(arm-empty)")}, {form("(jammed)")}, {}});
  Replanner replanner;
  const Result<ReadyPlan> whole = replanner.plan(task, {}, never);
  ASSERT_TRUE(whole);
  take_first_step(task, whole->steps);
  const Result<ReadyPlan> rest = replanner.plan(task, {}, never);
  ASSERT_TRUE(rest);
  EXPECT_EQ(rest->engine, "kept");
  EXPECT_EQ(rest->steps.size() + 1, whole->steps.size());
  task.initials.push_back(form("(jammed)"));
  EXPECT_EQ(replanner.plan(task, {}, never).error().symbol, "no-plan");
  std::erase(task.initials, form("(jammed)"));
  EXPECT_TRUE(replanner.plan(task, {}, never));
}

TEST(Replanner, PlansAsShortlyAsFromTheStartWhateverFactsComeAndGo) {
  std::size_t plans = 0;
  for (std::uint64_t seed = 1; seed <= 350 && !testing::Test::HasFailure(); ++seed) {
    Random random(seed);
    PlanningTask task = seed % 4 == 0 ? random_nonsense(random) : random_conditions(random);
    std::vector<Datum> gone;
    Replanner replanner;
    for (int change = 0; change < 8; ++change) {
      SCOPED_TRACE(fmt::format("seed {}, change {}: {}", seed, change, show(task)));
      expect_shortest(replanner, task);
      plans += plan_anew(task).steps.has_value() ? 1 : 0;
      std::vector<Datum>& from = random.below(2) == 0 ? gone : task.initials;
      std::vector<Datum>& to = &from == &gone ? task.initials : gone;
      if (from.empty()) continue;
      const auto moved = from.begin() + static_cast<std::ptrdiff_t>(random.below(from.size()));
      to.push_back(*moved);
      from.erase(moved);
    }
  }
  EXPECT_GT(plans, 400u);
}

TEST(Replanner, KnowsWhatItKnewAfterAPlanThatWasCancelled) {
  Random random(7);
  PlanningTask task = random_blocks(8, random);
  Replanner replanner;
  const Result<ReadyPlan> whole = replanner.plan(task, {}, never);
  ASSERT_TRUE(whole);
  const std::vector<Datum> initials = task.initials;
  for (int i = 0; i < 2; ++i) meddle(task, random);
  EXPECT_FALSE(replanner.plan(task, {}, [] { return true; }));
  task.initials = initials;
  const Result<ReadyPlan> again = replanner.plan(task, {}, never);
  ASSERT_TRUE(again);
  EXPECT_EQ(again->engine, "kept");
  EXPECT_EQ(again->steps, whole->steps);
}

TEST(Replanner, NeverUsesWhatACancelledPlanMadeFastLeftHalfDone) {
  Random random(9);
  const PlanningTask task = random_blocks(40, random);
  const Budget budget{.nodes = 2000};
  const Result<ReadyPlan> whole = Replanner().plan(task, budget, never);
  ASSERT_TRUE(whole);
  int cancelled = 0;
  for (int patience = 1; patience < 400; patience += 29) {
    Replanner replanner;
    int looks = 0;
    const Result<ReadyPlan> first = replanner.plan(task, budget, [&] { return ++looks == patience; });
    if (first) break;  // it is long enough for a first plan
    ++cancelled;
    EXPECT_EQ(first.error().symbol, "cancelled");
    const Result<ReadyPlan> again = replanner.plan(task, budget, never);
    ASSERT_TRUE(again) << again.error().sentence;
    EXPECT_EQ(again->steps, whole->steps);
  }
  EXPECT_GT(cancelled, 2);
}

}  // namespace
}  // namespace pizarra::planner
