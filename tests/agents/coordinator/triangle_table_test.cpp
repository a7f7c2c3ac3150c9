#include "agents/coordinator/plan/triangle_table.hpp"

#include <algorithm>
#include <gtest/gtest.h>

#include "agents/coordinator/plan/vigil.hpp"
#include "blackboard/time/random.hpp"
#include "lisp/reader.hpp"

namespace pizarra::coordinator {
namespace {

Datum d(std::string_view text) { return read_one(text).value(); }

std::vector<Datum> all(std::string_view text) {
  const Datum read = d(text);
  return {read.items().begin(), read.items().end()};
}

Facts facts(std::string_view text) {
  const std::vector<Datum> items = all(text);
  return {items.begin(), items.end()};
}

GroundOperation pick_up(const std::string& x) {
  return {d("(PICK-UP " + x + ")"), all("((clear " + x + ") (on-table " + x + ") (arm-empty))"),
          all("((holding " + x + "))"), all("((clear " + x + ") (on-table " + x + ") (arm-empty))")};
}

GroundOperation stack(const std::string& x, const std::string& y) {
  return {d("(STACK " + x + " " + y + ")"), all("((holding " + x + ") (clear " + y + "))"),
          all("((arm-empty) (clear " + x + ") (on " + x + " " + y + "))"),
          all("((holding " + x + ") (clear " + y + "))")};
}

// triangle on square, then circle on triangle.
TriangleTable tower() {
  return TriangleTable({pick_up("t"), stack("t", "s"), pick_up("c"), stack("c", "t")}, all("((on c t) (on t s))"));
}

constexpr std::string_view start = "((on-table t) (on-table s) (on-table c) (clear t) (clear s) (clear c) (arm-empty))";

TEST(TriangleTable, StartsWithTheFirstOperation) { EXPECT_EQ(tower().furthest(facts(start)), 0u); }

TEST(TriangleTable, IsDoneWhenTheGoalHolds) {
  EXPECT_EQ(tower().furthest(facts("((on c t) (on t s) (holding x))")), 4u);
}

TEST(TriangleTable, SkipsWhatSomebodyElseDid) {
  EXPECT_EQ(tower().furthest(facts("((on t s) (clear t) (on-table c) (clear c) (arm-empty))")), 2u);
}

TEST(TriangleTable, RepeatsWhatWasUndoneWhileThePlanCoversIt) { EXPECT_EQ(tower().furthest(facts(start)), 0u); }

TEST(TriangleTable, AsksForANewPlanWhenNoSuffixHolds) {
  EXPECT_EQ(tower().furthest(facts("((on x c) (on-table c) (clear t) (clear s) (arm-empty))")), std::nullopt);
}

TEST(TriangleTable, KeepsWhatTheRestNeedsDuringAnOperation) {
  const Facts kept = tower().kept_during(2);
  EXPECT_EQ(kept, facts("((clear t) (on t s))"));
}

// The defining property: whenever a suffix's needs hold, carrying it out reaches the goal, its preconditions holding
// all along.
TEST(TriangleTable, EverySuffixThatHoldsReachesTheGoal) {
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
    std::vector<GroundOperation> plan;
    const Facts initial = state;
    for (int i = 0; i < 5; ++i) {
      GroundOperation operation{list("op"_sym, i), {}, some(2), {}};
      for (const Datum& fact : state) {
        if (random.below(3) == 0) operation.preconditions.push_back(fact);
      }
      for (const Datum& fact : some(2)) {
        if (std::ranges::find(operation.adds, fact) == operation.adds.end()) operation.deletes.push_back(fact);
      }
      for (const Datum& fact : operation.deletes) state.erase(fact);
      state.insert(operation.adds.begin(), operation.adds.end());
      plan.push_back(std::move(operation));
    }
    std::vector<Datum> goal;
    for (const Datum& fact : state) {
      if (random.below(2) == 0) goal.push_back(fact);
    }
    const TriangleTable table(plan, goal);
    EXPECT_TRUE(std::ranges::includes(initial, table.needed(0)));
    for (std::size_t from = 0; from <= plan.size(); ++from) {
      Facts now = table.needed(from);
      for (std::size_t i = from; i < plan.size(); ++i) {
        for (const Datum& fact : plan[i].preconditions) EXPECT_TRUE(now.contains(fact));
        for (const Datum& fact : plan[i].deletes) now.erase(fact);
        now.insert(plan[i].adds.begin(), plan[i].adds.end());
      }
      for (const Datum& fact : goal) EXPECT_TRUE(now.contains(fact));
    }
  }
}

TEST(Vigil, NoticesALostPreconditionUntilTheOperationCommits) {
  Vigil vigil;
  vigil.begin(tower(), 2);
  EXPECT_TRUE(vigil.check(facts("((clear c) (on-table c) (arm-empty) (clear t) (on t s))")));
  const Result<void> lost = vigil.check(facts("((clear c) (arm-empty) (clear t) (on t s))"));
  ASSERT_FALSE(lost);
  EXPECT_EQ(lost.error().symbol, "difference");
  EXPECT_EQ(lost.error().subject, d("((on-table c))"));
  vigil.commit();
  EXPECT_TRUE(vigil.check(facts("((holding c) (clear t) (on t s))")));
}

TEST(Vigil, NoticesWhatTheRestOfThePlanLosesThroughout) {
  Vigil vigil;
  vigil.begin(tower(), 2);
  vigil.commit();
  const Result<void> lost = vigil.check(facts("((holding c) (clear t))"));
  ASSERT_FALSE(lost);
  EXPECT_EQ(lost.error().subject, d("((on t s))"));
}

TEST(Vigil, EndsEverythingWhenInterrupted) {
  Vigil vigil;
  vigil.begin(tower(), 0);
  vigil.interrupt();
  EXPECT_EQ(vigil.check(facts(start)).error().symbol, "interrupted");
}

}  // namespace
}  // namespace pizarra::coordinator
