#include <fmt/format.h>
#include <gtest/gtest.h>

#include "lisp/writer.hpp"
#include "tests/agents/planner/planning_domains.hpp"

namespace pizarra {
namespace {

PlanningTask two_blocks() {
  PlanningTask task = blocks_domain(2);
  task.initials = facts_of("(on-table b0) (on b1 b0) (clear b1) (arm-empty)");
  task.goals = facts_of("(on b0 b1)");
  return task;
}

std::string refusal(const PlanningTask& task) {
  const Result<Problem> problem = ground(task);
  return problem ? "none" : fmt::format("{}: {}", problem.error().symbol, write(problem.error().subject));
}

TEST(Grounding, LeavesOutWhatNoOperatorChanges) {
  Random random(1);
  const Result<Problem> problem = ground(random_logistics(random));
  ASSERT_TRUE(problem);
  for (const Datum& fact : problem->facts) EXPECT_NE(fact.head(), "road");
}

TEST(Grounding, LeavesOutActionsThatCanNeverBeTaken) {
  PlanningTask task = two_blocks();
  task.initials = facts_of("(on-table b0) (clear b0) (on-table b1) (arm-empty)");  // b1 is covered by nothing known
  task.goals = facts_of("(holding b0)");
  const Result<Problem> problem = ground(task);
  ASSERT_TRUE(problem);
  for (const GroundAction& action : problem->actions) EXPECT_NE(action.name, form("(PICK-UP b1)"));
}

TEST(Grounding, KeepsWhatIsAddedOutOfWhatIsDeleted) {
  PlanningTask task;
  task.operators = {{"SPIN", {}, facts_of("(a)"), facts_of("(a) (b)"), facts_of("(a) (c)")}};
  task.initials = facts_of("(a) (c)");
  task.goals = facts_of("(b)");
  const Result<Problem> problem = ground(task);
  ASSERT_TRUE(problem);
  ASSERT_EQ(problem->actions.size(), 1u);
  EXPECT_EQ(problem->actions[0].adds.size(), 2u);
  ASSERT_EQ(problem->actions[0].deletes.size(), 1u);
  EXPECT_EQ(problem->facts[problem->actions[0].deletes[0]], form("(c)"));
}

TEST(Grounding, RefusesWhatIsUnknownAndSaysWhatItIs) {
  PlanningTask task = two_blocks();
  task.goals = facts_of("(on b0 star)");
  EXPECT_EQ(refusal(task), "unknown-object: star");
  task = two_blocks();
  task.goals = facts_of("(under b0 b1)");
  EXPECT_EQ(refusal(task), "unknown-predicate: (under b0 b1)");
  task = two_blocks();
  task.initials.push_back(form("(clear b7)"));
  EXPECT_EQ(refusal(task), "unknown-object: b7");
}

TEST(Grounding, RefusesWhatIsMalformed) {
  PlanningTask task = two_blocks();
  task.goals = facts_of("(on b0)");
  EXPECT_EQ(refusal(task), "bad-task: (on b0)");
  task = two_blocks();
  task.operators[0].preconditions.push_back(form("(clear ?z)"));
  EXPECT_EQ(refusal(task), "bad-task: (clear ?z)");
  task = two_blocks();
  task.operators[0].preconditions.push_back(form("(not (holding ?x))"));
  EXPECT_EQ(refusal(task), "bad-task: (not (holding ?x))");
  task = two_blocks();
  task.objects.push_back(task.objects.front());
  EXPECT_EQ(refusal(task), "bad-task: b0");
}

TEST(Grounding, RefusesMoreActionsThanItsBound) {
  PlanningTask task = blocks_domain(300);
  task.operators.push_back(
      {"SHUFFLE", {{"?x", "OBJECT"}, {"?y", "OBJECT"}, {"?z", "OBJECT"}}, {}, facts_of("(on ?x ?y) (on ?y ?z)"), {}});
  task.goals = facts_of("(on b0 b1)");
  EXPECT_EQ(refusal(task).substr(0, 9), "too-large");
}

TEST(Validator, AcceptsAPlanThatWorks) {
  const PlanSteps steps{facts_of("(UNSTACK b1 b0)"), facts_of("(PUT-DOWN b1)"), facts_of("(PICK-UP b0)"),
                        facts_of("(STACK b0 b1)")};
  EXPECT_TRUE(validate_plan(two_blocks(), steps));
}

TEST(Validator, CatchesEveryKindOfBrokenPlan) {
  const auto subject = [](const PlanSteps& steps) {
    const Result<void> valid = validate_plan(two_blocks(), steps);
    return valid ? "none" : write(valid.error().subject);
  };
  EXPECT_EQ(subject({}), "(on b0 b1)");
  EXPECT_EQ(subject({facts_of("(PICK-UP b0)")}), "(PICK-UP b0)");
  EXPECT_EQ(subject({facts_of("(UNSTACK b1 b0)"), facts_of("(PUT-DOWN b1)")}), "(on b0 b1)");
  EXPECT_EQ(subject({facts_of("(UNSTACK b1 b0)"), facts_of("(PUT-DOWN b1) (STACK b1 b0)")}),
            "((PUT-DOWN b1) (STACK b1 b0))");
  EXPECT_EQ(subject({facts_of("(FLY b1)")}), "(FLY b1)");
  EXPECT_EQ(subject({facts_of("(UNSTACK b1 b7)")}), "(UNSTACK b1 b7)");
  EXPECT_EQ(subject({facts_of("(UNSTACK b1)")}), "(UNSTACK b1)");
}

}  // namespace
}  // namespace pizarra
