#include "agents/planner/graphplan/graphplan.hpp"

#include "agents/planner/agent/planner_forms.hpp"
#include "agents/planner/explanation/no_plan.hpp"
#include "agents/planner/judge/breadth_first.hpp"
#include "agents/planner/task/grounding.hpp"
#include "lisp/writer.hpp"
#include "tests/agents/planner/engine_contract.hpp"

namespace pizarra::planner {
namespace {

Outcome plan(const PlanningTask& task, const Budget& budget = {}) {
  const Result<Problem> problem = ground(task);
  EXPECT_TRUE(problem) << problem.error().sentence;
  return Graphplan().solve(*problem, budget, never);
}

Failure refused_by_graphplan(const PlanningTask& task) {
  const Result<Problem> problem = ground(task);
  const Outcome outcome = Graphplan().solve(*problem, {}, never);
  EXPECT_EQ(outcome.kind, Outcome::Kind::none);
  return explain(*problem, outcome);
}

template <class Make>
void compare_many(std::uint64_t seeds, Make make) {
  Graphplan engine;
  expect_fewest_steps(engine, seeds, make);
}

TEST(Graphplan, PlansAsShortAsAnyForRandomBlocks) {
  compare_many(150, [](Random& random) { return random_blocks(2 + random.below(3), random); });
}

TEST(Graphplan, PlansAsShortAsAnyForRandomLogistics) {
  compare_many(60, [](Random& random) { return random_logistics(random); });
}

TEST(Graphplan, PlansAsShortAsAnyForARobotWithTwoGrippers) {
  compare_many(60, [](Random& random) { return random_gripper(random); });
}

TEST(Graphplan, PlansOrProvesThatThereIsNoneForRandomNonsense) {
  compare_many(3000, [](Random& random) { return random_nonsense(random); });
}

TEST(Graphplan, PlansOrProvesThatThereIsNoneWhereFactsMustBeAbsent) {
  compare_many(500, [](Random& random) { return random_conditions(random); });
}

TEST(Graphplan, AgreesWithTheOracleOnRandomGoalsThatAreMostlyImpossible) {
  compare_many(150, random_impossible_blocks);
}

TEST(Graphplan, SolvesRandomBlocksUpToEightWithinItsBudgetAndLargerOnesOrSaysSo) {
  for (std::size_t blocks = 4; blocks <= 10; ++blocks) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      Random random(1000 * blocks + seed);
      const PlanningTask task = random_blocks(blocks, random);
      SCOPED_TRACE(fmt::format("{} blocks, seed {}", blocks, 1000 * blocks + seed));
      const Result<Problem> problem = ground(task);
      const Budget budget = blocks <= 8 ? Budget{} : Budget{.nodes = 100'000};
      const Outcome outcome = Graphplan().solve(*problem, budget, never);
      if (blocks > 8 && outcome.kind == Outcome::Kind::gave_up) continue;
      ASSERT_EQ(outcome.kind, Outcome::Kind::plan);
      const Result<void> valid = validate_plan(task, steps_of(*problem, outcome.steps));
      EXPECT_TRUE(valid) << valid.error().sentence;
    }
  }
}

TEST(Graphplan, NeedsNoStepForWhatHoldsAlready) {
  PlanningTask task = blocks_domain(2);
  task.initials = facts_of("(on-table b0) (on b1 b0) (clear b1) (arm-empty)");
  task.goals = facts_of("(on b1 b0)");
  const Outcome outcome = plan(task);
  EXPECT_EQ(outcome.kind, Outcome::Kind::plan);
  EXPECT_TRUE(outcome.steps.empty());
}

TEST(Graphplan, NeverStacksABlockOnItself) {
  PlanningTask task = blocks_domain(2);
  task.initials = facts_of("(on-table b0) (on-table b1) (clear b0) (clear b1) (arm-empty)");
  task.goals = facts_of("(on b0 b0)");
  EXPECT_EQ(refused_by_graphplan(task).subject, form("((on b0 b0))"));
}

TEST(Graphplan, NamesAGoalThatNothingBringsAbout) {
  PlanningTask task = blocks_domain(2);
  task.initials = facts_of("(on-table b0) (clear b0) (arm-empty) (on-table b1) (clear b1) (painted b0)");
  task.goals = facts_of("(on b0 b1) (painted b1)");
  const Failure failure = refused_by_graphplan(task);
  EXPECT_EQ(failure.symbol, "no-plan");
  EXPECT_EQ(failure.subject, form("((painted b1))"));
  EXPECT_EQ(failure.sentence, "no plan exists: (painted b1) can never hold from here");
}

TEST(Graphplan, NamesTwoGoalsThatExcludeEachOther) {
  PlanningTask task = blocks_domain(4);
  Random random(1);
  task.initials = random_blocks(4, random).initials;
  task.goals = facts_of("(on b3 b2) (on b0 b1) (on b0 b2)");
  const Failure failure = refused_by_graphplan(task);
  EXPECT_EQ(failure.subject.size(), 2u);
}

TEST(Graphplan, ProvesThatARingOfManyBlocksCannotBeBuiltAndNamesOnlyTheRing) {
  for (std::size_t blocks = 4; blocks <= 10; ++blocks) {
    Random random(blocks);
    PlanningTask task = random_blocks(blocks, random);
    task.goals = facts_of("(on b3 b0) (on b0 b1) (on b1 b2) (on b2 b0)");
    const Failure failure = refused_by_graphplan(task);
    EXPECT_EQ(failure.symbol, "no-plan");
    EXPECT_LE(failure.subject.size(), 3u) << failure.sentence;
  }
}

TEST(Graphplan, SaysWhichBoundMadeItGiveUp) {
  Random random(5);
  const PlanningTask task = random_blocks(9, random);
  const Outcome few_nodes = plan(task, {.nodes = 3});
  EXPECT_EQ(few_nodes.kind, Outcome::Kind::gave_up);
  EXPECT_EQ(few_nodes.spent, "3 search nodes");
  const Outcome few_levels = plan(task, {.levels = 2});
  EXPECT_EQ(few_levels.kind, Outcome::Kind::gave_up);
  EXPECT_EQ(few_levels.spent, "2 levels");
  const Outcome little_memory = plan(task, {.bytes = 1 << 10});
  EXPECT_EQ(little_memory.kind, Outcome::Kind::gave_up);
  EXPECT_EQ(little_memory.spent, "0 MB of memory");
}

TEST(Graphplan, StopsWhenCancelled) {
  Random random(5);
  const Result<Problem> problem = ground(random_blocks(6, random));
  const Outcome outcome = Graphplan().solve(*problem, {}, [] { return true; });
  EXPECT_EQ(outcome.kind, Outcome::Kind::cancelled);
}

TEST(Graphplan, GivesTheSamePlanEveryTime) {
  Random random(7);
  const PlanningTask task = random_blocks(7, random);
  const Outcome first = plan(task);
  const Outcome second = plan(task);
  EXPECT_EQ(first.steps, second.steps);
  EXPECT_EQ(first.nodes, second.nodes);
}

TEST(BreadthFirst, AgreesWithGraphplanOnWhetherThereIsAPlan) {
  for_random_tasks(500, random_nonsense, [](const PlanningTask& task) {
    const Result<Problem> problem = ground(task);
    const Outcome simple = BreadthFirst().solve(*problem, {}, never);
    EXPECT_EQ(simple.kind, Graphplan().solve(*problem, {}, never).kind);
    if (simple.kind != Outcome::Kind::plan) return;
    EXPECT_TRUE(validate_plan(task, steps_of(*problem, simple.steps)));
  });
}

TEST(BreadthFirst, SaysWhetherThereIsAnyPlan) {
  Random random(3);
  PlanningTask task = random_blocks(4, random);
  EXPECT_EQ(any_plan(task).value(), true);
  task.goals = facts_of("(on b0 b1) (on b1 b0)");
  EXPECT_EQ(any_plan(task).value(), false);
  task.goals = facts_of("(on b0 b1) (on b1 star)");
  EXPECT_EQ(any_plan(task).error().symbol, "unknown-object");
  const PlanningTask large = random_blocks(8, random);
  EXPECT_EQ(any_plan(large, {.nodes = 100}).error().symbol, "gave-up");
}

}  // namespace
}  // namespace pizarra::planner
