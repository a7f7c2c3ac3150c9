#include "agents/planner/task/grounding.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "lisp/writer.hpp"
#include "tests/agents/planner/planning_domains.hpp"

namespace pizarra::planner {
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

PlanningTask lamps() {
  PlanningTask task;
  task.types = {{"lamp", "thing"}, {"torch", "lamp"}};
  task.objects = {{"l"_sym, "lamp"}, {"t"_sym, "torch"}, {"s"_sym, "stone"}};
  task.operators = {{"LIGHT", {{"?x", "lamp"}}, {}, facts_of("(lit ?x)"), {}},
                    {"DOUSE", {{"?x", "torch"}}, facts_of("(lit ?x)"), {}, facts_of("(lit ?x)")}};
  task.operators[0].absents = facts_of("(lit ?x)");
  task.initials = facts_of("(lit t)");
  task.goals = facts_of("(lit l)");
  task.absent_goals = facts_of("(lit t)");
  return task;
}

TEST(Grounding, MakesAFactOfWhatMustBeAbsent) {
  const Result<Problem> problem = ground(lamps());
  ASSERT_TRUE(problem);
  EXPECT_EQ(problem->facts, facts_of("(lit l) (not (lit t)) (not (lit l)) (lit t)"));
  ASSERT_EQ(problem->actions.size(), 3u);
  const GroundAction& douse = problem->actions[2];
  EXPECT_EQ(douse.name, form("(DOUSE t)"));
  EXPECT_EQ(douse.adds, std::vector<std::size_t>{1});
  EXPECT_EQ(douse.deletes, std::vector<std::size_t>{3});
  EXPECT_TRUE(problem->initials.test(2) && problem->initials.test(3));
}

TEST(Grounding, TakesAnObjectForOneOfItsParentsTypes) {
  const Result<Problem> problem = ground(lamps());
  ASSERT_TRUE(problem);
  std::vector<Datum> names;
  for (const GroundAction& action : problem->actions) names.push_back(action.name);
  EXPECT_EQ(names, facts_of("(LIGHT l) (LIGHT t) (DOUSE t)"));
}

TEST(Grounding, LeavesOutActionsThatEqualitiesRuleOut) {
  PlanningTask task;
  task.objects = {{"a"_sym, "T"}, {"b"_sym, "T"}};
  task.operators = {{"SWAP", {{"?x", "T"}, {"?y", "T"}}, {}, facts_of("(swapped ?x ?y)"), {}}};
  task.operators[0].equalities = {{"?x"_sym, "?y"_sym, false}, {"?x"_sym, "a"_sym, true}};
  task.goals = facts_of("(swapped a b)");
  const Result<Problem> problem = ground(task);
  ASSERT_TRUE(problem);
  ASSERT_EQ(problem->actions.size(), 1u);
  EXPECT_EQ(problem->actions[0].name, form("(SWAP a b)"));
}

TEST(Grounding, AddsUpWhatAnActionCostsAndLeavesOutWhatHasNoPrice) {
  PlanningTask task;
  task.objects = {{"a"_sym, "T"}, {"b"_sym, "T"}};
  task.operators = {{"GO", {{"?x", "T"}}, {}, facts_of("(been ?x)"), {}}};
  task.operators[0].costs = facts_of("2 (toll ?x) 1");
  task.values = {{form("(toll a)"), 40}};
  task.goals = facts_of("(been a)");
  EXPECT_EQ(ground(task)->actions.size(), 2u);
  EXPECT_EQ(ground(task)->actions[0].cost, 1);
  task.counts_cost = true;
  const Result<Problem> problem = ground(task);
  ASSERT_EQ(problem->actions.size(), 1u);
  EXPECT_EQ(problem->actions[0].cost, 43);
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

TEST(Validator, KnowsTypesAbsencesEqualitiesAndCosts) {
  PlanningTask task = lamps();
  const auto refused = [&](const PlanSteps& steps) {
    const Result<void> valid = validate_plan(task, steps);
    return valid ? "none" : valid.error().sentence;
  };
  EXPECT_EQ(refused({facts_of("(LIGHT l) (DOUSE t)")}), "none");
  EXPECT_EQ(refused({facts_of("(LIGHT l)")}), "(lit t) holds in the end");
  EXPECT_EQ(refused({facts_of("(LIGHT t)")}), "(LIGHT t) needs (lit t) not to hold");
  EXPECT_EQ(refused({facts_of("(LIGHT s)")}), "s in (LIGHT s) is no lamp");
  EXPECT_EQ(refused({facts_of("(DOUSE t)"), facts_of("(LIGHT l) (LIGHT t)")}), "(lit t) holds in the end");
  task.operators[0].equalities = {{"?x"_sym, "t"_sym, false}};
  EXPECT_EQ(refused({facts_of("(LIGHT t)")}), "(LIGHT t) needs ?x and t to be different");
  task.operators[1].costs = facts_of("(price ?x)");
  task.counts_cost = true;
  EXPECT_EQ(refused({facts_of("(DOUSE t)")}), "the cost of (DOUSE t) is not defined");
}

TEST(Validator, RefusesAStepInWhichOneAddsWhatAnotherNeedsAbsent) {
  PlanningTask task;
  task.operators = {{"A", {}, {}, facts_of("(p)"), {}}, {"B", {}, {}, facts_of("(q)"), {}}};
  task.operators[1].absents = facts_of("(p)");
  task.goals = facts_of("(q)");
  EXPECT_TRUE(validate_plan(task, {facts_of("(B)"), facts_of("(A)")}));
  EXPECT_FALSE(validate_plan(task, {facts_of("(A) (B)")}));
  EXPECT_FALSE(validate_plan(task, {facts_of("(B) (A)")}));
}

}  // namespace
}  // namespace pizarra::planner
