#include "agents/coordinator/plan/vigil.hpp"

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

TEST(Vigil, NoticesALostPreconditionUntilTheOperationCommits) {
  Vigil vigil;
  vigil.begin(pick_up, needed_after);
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
  vigil.begin(pick_up, needed_after);
  vigil.commit();
  const Result<void> lost = vigil.check(facts("((holding c) (clear t))"));
  ASSERT_FALSE(lost);
  EXPECT_EQ(lost.error().subject, d("((on t s))"));
}

TEST(Vigil, EndsEverythingWhenInterrupted) {
  Vigil vigil;
  vigil.begin(pick_up, needed_after);
  vigil.interrupt();
  EXPECT_EQ(vigil.check(facts("((clear c) (on-table c) (arm-empty) (clear t) (on t s))")).error().symbol,
            "interrupted");
}

}  // namespace
}  // namespace pizarra::coordinator
