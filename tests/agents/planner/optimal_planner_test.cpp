#include "agents/planner/agent/planner_forms.hpp"
#include "agents/planner/explanation/fewest_culprits.hpp"
#include "agents/planner/guided/guided_search.hpp"
#include "agents/planner/judge/breadth_first.hpp"
#include "agents/planner/optimal/optimal_search.hpp"
#include "agents/planner/optimal/sat_search.hpp"
#include "agents/planner/optimal/step_search.hpp"
#include "agents/planner/task/grounding.hpp"
#include "lisp/writer.hpp"
#include "tests/agents/planner/engine_contract.hpp"

namespace pizarra::planner {
namespace {

// Satisfiability without the searches that come before it.
class SatAlone : public PlanEngine {
 public:
  Outcome solve(const Problem& problem, const Budget& budget, const std::function<bool()>& cancelled) override {
    if (problem.goals.subset_of(problem.initials)) {
      return {.kind = Outcome::Kind::plan};
    }
    const Exclusions exclusions(problem);
    return SatSearch(problem, exclusions).run(1, budget, cancelled);
  }
};

// A* alone, under the bound of whatever resource every action needs.
class GuidedAlone : public PlanEngine {
 public:
  Outcome solve(const Problem& problem, const Budget& budget, const std::function<bool()>& cancelled) override {
    const Exclusions exclusions(problem);
    const DeadEnds dead_ends(problem, exclusions);
    for (const FactGroup& group : exclusion_groups(exclusions)) {
      LandmarkBound bound(problem, exclusions, group);
      if (!bound.counts_every_action()) continue;
      Nearness nearness(problem);
      return GuidedSearch(problem, nearness, bound, &dead_ends).run(budget, cancelled);
    }
    ADD_FAILURE() << "no resource of all actions";
    return {};
  }
};

template <class Engine>
class FewestSteps : public testing::Test {
 protected:
  Engine engine;
};
using Engines = testing::Types<OptimalPlanner, SatAlone>;
TYPED_TEST_SUITE(FewestSteps, Engines);

TYPED_TEST(FewestSteps, ForRandomBlocks) {
  expect_fewest_steps(this->engine, 150, [](Random& random) { return random_blocks(2 + random.below(3), random); });
}

TYPED_TEST(FewestSteps, ForRandomLogistics) { expect_fewest_steps(this->engine, 60, random_logistics); }

TYPED_TEST(FewestSteps, ForARobotWithTwoGrippers) { expect_fewest_steps(this->engine, 60, random_gripper); }

TYPED_TEST(FewestSteps, ForRandomTowersOfHanoi) { expect_fewest_steps(this->engine, 200, random_hanoi); }

TYPED_TEST(FewestSteps, ForRandomNonsense) { expect_fewest_steps(this->engine, 1500, random_nonsense); }

TYPED_TEST(FewestSteps, WhereFactsMustBeAbsent) { expect_fewest_steps(this->engine, 400, random_conditions); }

TYPED_TEST(FewestSteps, ForGoalsThatAreMostlyImpossible) {
  expect_fewest_steps(this->engine, 150, random_impossible_blocks);
}

TYPED_TEST(FewestSteps, WithoutIdleActions) {
  for (const auto make : {random_gripper, random_logistics}) {
    for_random_tasks(60, make, [&](const PlanningTask& task) { expect_no_idle_action(this->engine, task); });
  }
}

TEST(StepSearch, FindsFewestStepsWhereStatesHaveFewSteps) {
  StepSearch engine;
  expect_fewest_steps(engine, 100, [](Random& random) { return random_blocks(2 + random.below(3), random); });
  expect_fewest_steps(engine, 60, random_logistics);
  expect_fewest_steps(engine, 60, random_gripper);
  expect_fewest_steps(engine, 100, random_hanoi);
  expect_fewest_steps(engine, 1000, random_nonsense);
  expect_fewest_steps(engine, 100, random_impossible_blocks);
}

TEST(GuidedSearch, FindsFewestStepsForRandomBlocks) {
  GuidedAlone engine;
  expect_fewest_steps(engine, 150, [](Random& random) { return random_blocks(2 + random.below(3), random); });
}

TEST(GuidedSearch, AgreesWithBreadthFirstSearchOnFiveAndSixBlocksOfWhichTheGoalsNameSome) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    Random random(seed);
    PlanningTask task = random_blocks(5 + random.below(2), random);
    while (task.goals.size() > 1 && random.below(3) == 0) task.goals.pop_back();
    if (task.goals.empty()) continue;
    SCOPED_TRACE(fmt::format("seed {}: {}", seed, show(task)));
    const Result<Problem> problem = ground(task);
    const Outcome outcome = GuidedAlone().solve(*problem, {}, never);
    EXPECT_EQ(outcome.steps.size(), BreadthFirst().solve(*problem, {}, never).steps.size());
    EXPECT_TRUE(validate_plan(task, steps_of(*problem, outcome.steps)));
  }
}

// The bound of every resource, and from every state on the way.
void expect_admissible_bounds(const PlanningTask& task) {
  const std::optional<std::size_t> fewest = fewest_steps(task);
  const Result<Problem> problem = ground(task);
  if (!fewest) return;
  const Exclusions exclusions(*problem);
  const DeadEnds dead_ends(*problem, exclusions);
  const Outcome plan = StepSearch().solve(*problem, {}, never);
  for (const FactGroup& group : exclusion_groups(exclusions)) {
    LandmarkBound bound(*problem, exclusions, group);
    Bits state = problem->initials;
    for (std::size_t step = 0; step <= plan.steps.size(); ++step) {
      ASSERT_TRUE(exclusions.allow(state));
      EXPECT_FALSE(dead_ends.contain(state));
      const std::optional<std::size_t> steps = bound.from(state);
      ASSERT_TRUE(steps);
      EXPECT_LE(*steps, plan.steps.size() - step);
      if (step == plan.steps.size()) break;
      for (const std::size_t action : plan.steps[step]) state = after(state, problem->actions[action]);
    }
  }
}

TEST(LandmarkBound, NeverAsksForMoreStepsThanAPlanTakes) {
  for_random_tasks(1000, random_nonsense, expect_admissible_bounds);
  for_random_tasks(
      150, [](Random& random) { return random_blocks(2 + random.below(3), random); }, expect_admissible_bounds);
  for_random_tasks(60, random_logistics, expect_admissible_bounds);
  for_random_tasks(60, random_gripper, expect_admissible_bounds);
  for_random_tasks(300, random_conditions, expect_admissible_bounds);
}

// Without any one of the culprits the others can be reached.
void expect_minimal_culprits(const PlanningTask& task) {
  const Result<Problem> problem = ground(task);
  Outcome outcome = OptimalPlanner().solve(*problem, {}, never);
  if (outcome.kind != Outcome::Kind::none) return;
  blame_fewest(*problem, {}, never, outcome);
  for (std::size_t i = 0; i < outcome.culprits.size(); ++i) {
    std::vector<std::size_t> others = outcome.culprits;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
    const PlanningTask rest = blamed(task, *problem, others);
    EXPECT_TRUE(fewest_steps(rest)) << "these alone are to blame: " << show(rest);
  }
}

TEST(OptimalPlanner, BlamesAsFewGoalsAsItCan) {
  for_random_tasks(300, random_impossible_blocks, expect_minimal_culprits);
  for_random_tasks(1000, random_nonsense, expect_minimal_culprits);
  for_random_tasks(300, random_conditions, expect_minimal_culprits);
}

TEST(OptimalPlanner, ProvesThatARingOfManyBlocksCannotBeBuiltAndBlamesTheRing) {
  for (const std::size_t blocks : {4, 10, 20}) {
    Random random(blocks);
    PlanningTask task = random_blocks(blocks, random);
    task.goals = facts_of("(on b3 b0) (on b0 b1) (on b1 b2) (on b2 b0)");
    const Result<Problem> problem = ground(task);
    Outcome outcome = OptimalPlanner().solve(*problem, {}, never);
    ASSERT_EQ(outcome.kind, Outcome::Kind::none);
    blame_fewest(*problem, {}, never, outcome);
    EXPECT_LE(outcome.culprits.size(), 3u);
  }
}

TEST(OptimalPlanner, PlansForTwentyFiveBlocks) {
  Random random(25);
  const PlanningTask task = random_blocks(25, random);
  const Result<Problem> problem = ground(task);
  const Outcome outcome = OptimalPlanner().solve(*problem, {}, never);
  ASSERT_EQ(outcome.kind, Outcome::Kind::plan);
  EXPECT_EQ(outcome.engine, "guided");
  EXPECT_TRUE(validate_plan(task, steps_of(*problem, outcome.steps)));
}

TEST(OptimalPlanner, SaysWhichBoundMadeItGiveUp) {
  Random random(5);
  const Result<Problem> problem = ground(random_blocks(9, random));
  const Outcome few_nodes = OptimalPlanner().solve(*problem, {.nodes = 3}, never);
  EXPECT_EQ(few_nodes.kind, Outcome::Kind::gave_up);
  EXPECT_FALSE(few_nodes.spent.empty());
  const Result<Problem> parallel = ground(random_logistics(random));
  const Outcome little_memory = OptimalPlanner().solve(*parallel, {.bytes = 1 << 10}, never);
  EXPECT_EQ(little_memory.kind, Outcome::Kind::gave_up);
  EXPECT_FALSE(little_memory.spent.empty());
}

TEST(OptimalPlanner, StopsWhenCancelled) {
  Random random(5);
  for (const PlanningTask& task : {random_blocks(9, random), random_logistics(random), random_gripper(random)}) {
    const Result<Problem> problem = ground(task);
    EXPECT_EQ(OptimalPlanner().solve(*problem, {}, [] { return true; }).kind, Outcome::Kind::cancelled);
    EXPECT_EQ(SatAlone().solve(*problem, {}, [] { return true; }).kind, Outcome::Kind::cancelled);
  }
}

TEST(OptimalPlanner, GivesTheSamePlanEveryTime) {
  Random random(7);
  for (const PlanningTask& task : {random_blocks(7, random), random_logistics(random), random_gripper(random)}) {
    const Result<Problem> problem = ground(task);
    const Outcome first = OptimalPlanner().solve(*problem, {}, never);
    const Outcome second = OptimalPlanner().solve(*problem, {}, never);
    EXPECT_EQ(first.steps, second.steps);
    EXPECT_EQ(first.nodes, second.nodes);
    const Outcome by_sat = SatAlone().solve(*problem, {}, never);
    EXPECT_EQ(by_sat.steps, SatAlone().solve(*problem, {}, never).steps);
    EXPECT_EQ(by_sat.steps.size(), first.steps.size());
  }
}

TEST(OptimalSearch, CanBeCancelledWhereverItIsAndThenAnswersAsIfItHadNotBeen) {
  Random random(2);
  const Problem problem = ground(random_blocks(7, random)).value();
  std::size_t asked = 0;
  OptimalSearch undisturbed(problem);
  const Outcome expected = undisturbed.run({}, [&] { return ++asked == 0; });
  ASSERT_EQ(expected.kind, Outcome::Kind::plan);
  ASSERT_GT(asked, problem.actions.size()) << "it asks while it prepares, too";
  for (std::size_t patience = 0; patience < asked; patience += 1 + asked / 97) {
    SCOPED_TRACE(patience);
    OptimalSearch search(problem);
    std::size_t left = patience;
    EXPECT_EQ(search.run({}, [&] { return left == 0 || --left == 0; }).kind, Outcome::Kind::cancelled);
    EXPECT_EQ(search.run({}, never).steps.size(), expected.steps.size());
  }
}

TEST(OptimalPlanner, StopsLookingForWhomToBlameWhenCancelled) {
  Random random(2);
  const Problem problem = ground(random_blocks(9, random)).value();
  Outcome outcome{.kind = Outcome::Kind::none};
  problem.goals.for_each([&](std::size_t goal) { outcome.culprits.push_back(goal); });
  const std::vector<std::size_t> all = outcome.culprits;
  ASSERT_GE(all.size(), 2u);
  std::size_t asked = 0;
  blame_fewest(
      problem, {}, [&] { return ++asked > 0; }, outcome);
  EXPECT_EQ(outcome.culprits, all);
  EXPECT_EQ(asked, 1u);
}

}  // namespace
}  // namespace pizarra::planner
