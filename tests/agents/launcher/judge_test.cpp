#include "agents/launcher/judge.hpp"

#include <gtest/gtest.h>

#include "lisp/reader.hpp"
#include "lisp/writer.hpp"

namespace pizarra {
namespace {

Truth truth_of(const std::string& text) { return truth_from_datum(read_one(text).value()).value(); }

Judge judge_for(const std::string& domain) {
  const Result<Domain> read = read_domain_file(std::string(PIZARRA_SOURCE_DIR) + "/domains/" + domain);
  return Judge::make(read.value()).value();
}

std::vector<Datum> goal_of(const std::string& text) {
  const Datum facts = read_one(text).value();
  return {facts.items().begin(), facts.items().end()};
}

// The circle lies on the square; the triangle lies 100 mm to their left.
constexpr const char* pile =
    R"(((cube circle 450 -100 90 0 0 (on square) 1.0) (cube square 450 -100 30 0 0 table 1.0)
        (cube triangle 450 -200 30 0 0 table 1.0)
        (facts (on circle square) (on-table square) (on-table triangle) (clear circle) (clear triangle) (arm-empty))))";

TEST(Judge, ComparesNamesWithoutCase) {
  const Judge judge = judge_for("blocks.scm");
  const std::vector<Datum> facts = judge.facts(truth_of(pile)).value();
  EXPECT_TRUE(Judge::holds(goal_of("((on Circle SQUARE) (clear circle))"), facts));
  EXPECT_FALSE(Judge::holds(goal_of("((on circle square) (on triangle circle))"), facts));
}

TEST(Judge, TellsADomainsOwnPredicatesByItsRules) {
  const Judge judge = judge_for("numbered-places.scm");
  const std::vector<Datum> facts = judge.facts(truth_of(pile)).value();
  EXPECT_TRUE(Judge::holds(goal_of("((at square place-2) (at triangle place-1) (on circle square))"), facts));
  EXPECT_FALSE(Judge::holds(goal_of("((at triangle place-3))"), facts));
}

TEST(Judge, KnowsWhatNoPlanCanReach) {
  const Judge judge = judge_for("blocks.scm");
  const Truth truth = truth_of(pile);
  const std::vector<Datum> facts = judge.facts(truth).value();
  EXPECT_TRUE(judge.plan_exists(goal_of("((on square triangle))"), truth, facts).value());
  EXPECT_FALSE(judge.plan_exists(goal_of("((on square triangle) (on triangle square))"), truth, facts).value());
}

TEST(Judge, AGoalWithACubeThatIsGoneHasNoPlan) {
  const Judge judge = judge_for("blocks.scm");
  const Truth truth = truth_of(
      R"(((cube circle 0 0 -100 0 0 gone 0.0) (cube square 450 -100 30 0 0 table 1.0)
          (facts (on-table square) (clear square) (arm-empty))))");
  const std::vector<Datum> facts = judge.facts(truth).value();
  EXPECT_FALSE(judge.plan_exists(goal_of("((on circle square))"), truth, facts).value());
}

}  // namespace
}  // namespace pizarra
