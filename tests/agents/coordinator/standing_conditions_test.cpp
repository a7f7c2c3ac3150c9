#include "agents/coordinator/plan/standing_conditions.hpp"

#include <gtest/gtest.h>

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

// (PICK-UP c), which comes before (STACK c t) in a plan for (on c t) and (on t s).
const GroundOperation pick_up{d("(PICK-UP c)"), all("((clear c) (on-table c) (arm-empty))"), all("((holding c))"),
                              all("((clear c) (on-table c) (arm-empty))")};
const Facts needed_after = facts("((holding c) (clear t) (on t s))");

TEST(StandingConditions, NoticesALostPreconditionUntilTheOperationCommits) {
  const Interruption interruption;
  StandingConditions conditions(interruption);
  conditions.begin(pick_up, needed_after);
  EXPECT_TRUE(conditions.check(facts("((clear c) (on-table c) (arm-empty) (clear t) (on t s))")));
  const Result<void> lost = conditions.check(facts("((clear c) (arm-empty) (clear t) (on t s))"));
  ASSERT_FALSE(lost);
  EXPECT_EQ(lost.error().symbol, "difference");
  EXPECT_EQ(lost.error().subject, d("((on-table c))"));
  conditions.commit();
  EXPECT_TRUE(conditions.check(facts("((holding c) (clear t) (on t s))")));
}

TEST(StandingConditions, NoticesWhatTheRestOfThePlanLosesThroughout) {
  const Interruption interruption;
  StandingConditions conditions(interruption);
  conditions.begin(pick_up, needed_after);
  conditions.commit();
  const Result<void> lost = conditions.check(facts("((holding c) (clear t))"));
  ASSERT_FALSE(lost);
  EXPECT_EQ(lost.error().subject, d("((on t s))"));
}

TEST(StandingConditions, EndsEverythingWhenInterrupted) {
  Interruption interruption;
  StandingConditions conditions(interruption);
  conditions.begin(pick_up, needed_after);
  interruption.raise();
  EXPECT_EQ(conditions.check(facts("((clear c) (on-table c) (arm-empty) (clear t) (on t s))")).error().symbol,
            "interrupted");
}

}  // namespace
}  // namespace pizarra::coordinator
