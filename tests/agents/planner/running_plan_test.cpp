#include "agents/planner/agent/running_plan.hpp"

#include <algorithm>
#include <gtest/gtest.h>

#include "blackboard/time/random.hpp"
#include "lisp/reader.hpp"
#include "lisp/writer.hpp"

namespace pizarra::planner {
namespace {

using Facts = RunningPlan::Facts;

Datum d(std::string_view text) { return read_one(text).value(); }

std::vector<Datum> all(std::string_view text) {
  const Datum read = d(text);
  return {read.items().begin(), read.items().end()};
}

Facts facts(std::string_view text) {
  const std::vector<Datum> items = all(text);
  return {items.begin(), items.end()};
}

const std::vector<PlanningOperator> blocks{{.name = "PICK-UP",
                                            .parameters = {{"?x", "OBJECT"}},
                                            .preconditions = all("((clear ?x) (on-table ?x) (arm-empty))"),
                                            .adds = all("((holding ?x))"),
                                            .deletes = all("((clear ?x) (on-table ?x) (arm-empty))")},
                                           {.name = "STACK",
                                            .parameters = {{"?x", "OBJECT"}, {"?y", "OBJECT"}},
                                            .preconditions = all("((holding ?x) (clear ?y))"),
                                            .adds = all("((arm-empty) (clear ?x) (on ?x ?y))"),
                                            .deletes = all("((holding ?x) (clear ?y))")}};

// t on s, then c on t.
RunningPlan tower() {
  return RunningPlan(7, all("((PICK-UP t) (STACK t s) (PICK-UP c) (STACK c t))"), blocks, all("((on c t) (on t s))"));
}

constexpr std::string_view start = "((on-table t) (on-table s) (on-table c) (clear t) (clear s) (clear c) (arm-empty))";

TEST(RunningPlan, StartsWithTheFirstOperation) { EXPECT_EQ(tower().next(facts(start)), 0u); }

TEST(RunningPlan, IsDoneWhenTheGoalHolds) { EXPECT_EQ(tower().next(facts("((on c t) (on t s) (holding x))")), 4u); }

TEST(RunningPlan, SkipsWhatSomebodyElseDid) {
  EXPECT_EQ(tower().next(facts("((on t s) (clear t) (on-table c) (clear c) (arm-empty))")), 2u);
}

TEST(RunningPlan, AsksForANewPlanWhenNoEndServes) {
  EXPECT_EQ(tower().next(facts("((on x c) (on-table c) (clear t) (clear s) (arm-empty))")), std::nullopt);
}

TEST(RunningPlan, SaysWhatTheRestCountsOn) {
  EXPECT_EQ(write(tower().from(2)),
            "(2 ((PICK-UP c) (STACK c t)) ((arm-empty) (clear c) (clear t) (on t s) (on-table c)) "
            "((clear t) (holding c) (on t s)))");
  EXPECT_EQ(write(tower().from(4)), "(4 () ((on c t) (on t s)) ((on c t) (on t s)))");
}

TEST(RunningPlan, GoesOnFromItsFacts) {
  const std::vector<Datum> told = tower().facts();
  const Result<RunningPlan> again = RunningPlan::from_facts(told[0], told[1]);
  ASSERT_TRUE(again);
  EXPECT_EQ(again->facts(), told);
  EXPECT_EQ(again->number(), 7);
  EXPECT_EQ(again->next(facts(start)), 0u);
  EXPECT_EQ(RunningPlan::from_facts(told[0], d("(plan-needs 8 (() () () () ()))")).error().symbol, "bad-plan");
  EXPECT_EQ(RunningPlan::from_facts(told[0], d("(plan-needs 7 (()))")).error().symbol, "bad-plan");
}

// The defining property: whenever the needs of an end hold, carrying it out reaches the goal, its preconditions holding
// all along.
TEST(RunningPlan, EveryEndThatServesReachesTheGoal) {
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    std::vector<Datum> atoms;
    for (int i = 0; i < 8; ++i) atoms.push_back(list("f"_sym, i));
    const auto some = [&](std::uint64_t most) {
      std::vector<Datum> out;
      for (std::uint64_t n = random.below(most + 1); n > 0; --n) out.push_back(atoms[random.below(atoms.size())]);
      return out;
    };
    // A plan that works from a random state: preconditions are drawn from what holds before each operation.
    Facts state;
    for (const Datum& atom : some(8)) state.insert(atom);
    const Facts initial = state;
    std::vector<PlanningOperator> operators;
    std::vector<Datum> operations;
    for (int i = 0; i < 5; ++i) {
      PlanningOperator known{
          .name = "op-" + std::to_string(i), .parameters = {}, .preconditions = {}, .adds = some(2), .deletes = {}};
      for (const Datum& fact : state) {
        if (random.below(3) == 0) known.preconditions.push_back(fact);
      }
      for (const Datum& fact : some(2)) {
        if (std::ranges::find(known.adds, fact) == known.adds.end()) known.deletes.push_back(fact);
      }
      for (const Datum& fact : known.deletes) state.erase(fact);
      state.insert(known.adds.begin(), known.adds.end());
      operations.push_back(list(Datum::symbol(known.name)));
      operators.push_back(std::move(known));
    }
    std::vector<Datum> goal;
    for (const Datum& fact : state) {
      if (random.below(2) == 0) goal.push_back(fact);
    }
    const RunningPlan plan(1, operations, operators, goal);
    EXPECT_TRUE(plan.next(initial));
    for (std::size_t from = 0; from <= operations.size(); ++from) {
      const Datum end = plan.from(from);
      Facts now(end[2].items().begin(), end[2].items().end());
      for (std::size_t i = from; i < operators.size(); ++i) {
        for (const Datum& fact : operators[i].preconditions) EXPECT_TRUE(now.contains(fact));
        for (const Datum& fact : operators[i].deletes) now.erase(fact);
        now.insert(operators[i].adds.begin(), operators[i].adds.end());
      }
      for (const Datum& fact : goal) EXPECT_TRUE(now.contains(fact));
    }
  }
}

TEST(RunningPlan, NeedsThatWhatShallNotBeIsNot) {
  const RunningPlan plan(7, all("((PICK-UP c))"), blocks, all("((not (on-table c)) (not (on t s)))"));
  EXPECT_EQ(plan.next(facts("((clear c) (on-table c) (arm-empty))")), 0U);
  EXPECT_EQ(plan.next(facts("((holding c))")), 1U);
  EXPECT_EQ(plan.next(facts("((clear c) (on-table c) (arm-empty) (on t s))")), std::nullopt) << "nothing undoes that";
}

}  // namespace
}  // namespace pizarra::planner
