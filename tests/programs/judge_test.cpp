#include "programs/story/judge.hpp"

#include <gtest/gtest.h>

#include "lisp/reader.hpp"
#include "lisp/writer.hpp"
#include "programs/story/director.hpp"
#include "tests/source_dir.hpp"

namespace pizarra::programs {
namespace {

story::WorldState truth_of(const std::string& text) {
  return story::world_state_from_datum(read_one(text).value()).value();
}

story::Judge judge_for(const std::string& domain) {
  const Result<forms::Domain> read = forms::read_domain_file(source_dir() + "/domains/" + domain);
  return story::Judge::make(read.value(), 60).value();
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
  const story::Judge judge = judge_for("blocks.scm");
  const std::vector<Datum> facts = judge.facts(truth_of(pile)).value();
  EXPECT_TRUE(story::Judge::holds(goal_of("((on Circle SQUARE) (clear circle))"), facts));
  EXPECT_FALSE(story::Judge::holds(goal_of("((on circle square) (on triangle circle))"), facts));
}

TEST(Judge, TellsADomainsOwnPredicatesByItsRules) {
  const story::Judge judge = judge_for("numbered-places.scm");
  const std::vector<Datum> facts = judge.facts(truth_of(pile)).value();
  EXPECT_TRUE(story::Judge::holds(goal_of("((at square place-2) (at triangle place-1) (on circle square))"), facts));
  EXPECT_FALSE(story::Judge::holds(goal_of("((at triangle place-3))"), facts));
}

TEST(Judge, KnowsThatALargerCubeNeverComesOntoASmallerOne) {
  const Result<forms::Domain> read = forms::read_domain_file(source_dir() + "/domains/sizes.scm");
  const story::Judge judge = story::Judge::make(read.value(), 60, {{"Circle", 40}, {"square", 60}}).value();
  const story::WorldState truth =
      truth_of(R"(((cube circle 450 -150 80 0 0 (on square) 1.0) (cube square 450 -150 30 0 0 table 1.0)))");
  EXPECT_TRUE(judge.shows(goal_of("((on circle square) (at square place-1))"), truth).value());
  EXPECT_TRUE(judge.plan_exists(goal_of("((on circle square) (at square place-3))"), truth).value());
  EXPECT_FALSE(judge.plan_exists(goal_of("((on square circle))"), truth).value());
}

TEST(Judge, JudgesADomainThatSharesNoPredicateWithTheBlocks) {
  const Result<forms::Domain> domain = forms::read_domain(R"(
    (domain rows
      (types THING)
      (predicates (left-of (a THING) (b THING)) (lifted (a THING)))
      (perception
        (sees THING)
        (constant cube 60)
        (rule (lifted ?a) (seen ?a ? ? ?z) (> ?z (* 0.8 cube)))
        (rule (left-of ?a ?b) (seen ?a ? ?ay ?) (seen ?b ? ?by ?) (< ?ay (- ?by cube))))))",
                                                          "rows.scm");
  const story::Judge judge = story::Judge::make(domain.value(), 50).value();
  const std::vector<Datum> facts = judge.facts(truth_of(pile)).value();
  EXPECT_EQ(write(Datum::list(facts)), "((left-of triangle circle) (left-of triangle square) (lifted circle))");
}

TEST(Judge, WhatAHandCarriesOrWhatStandsOnSomethingLooseIsInNoState) {
  const story::Judge judge = judge_for("blocks.scm");
  const story::WorldState truth =
      truth_of(R"(((cube circle 450 -100 120 0 0 (on square) 1.0) (cube square 450 -100 60 0 0 carried 1.0)))");
  EXPECT_EQ(write(Datum::list(judge.facts(truth).value())), "((arm-empty))");
}

TEST(Judge, KnowsWhatNoPlanCanReach) {
  const story::Judge judge = judge_for("blocks.scm");
  const story::WorldState truth = truth_of(pile);
  EXPECT_TRUE(judge.plan_exists(goal_of("((on square triangle))"), truth).value());
  EXPECT_FALSE(judge.plan_exists(goal_of("((on square triangle) (on triangle square))"), truth).value());
}

TEST(Judge, AGoalWithACubeThatIsGoneHasNoPlan) {
  const story::Judge judge = judge_for("blocks.scm");
  const story::WorldState truth = truth_of(
      R"(((cube circle 0 0 -100 0 0 gone 0.0) (cube square 450 -100 30 0 0 table 1.0)
          (facts (on-table square) (clear square) (arm-empty))))");
  EXPECT_FALSE(judge.plan_exists(goal_of("((on circle square))"), truth).value());
}

// The circle leans against the square; nothing holds it in a state that a predicate names.
constexpr const char* leaning =
    R"(((cube circle 450 -145 38 0 35 loose 1.0) (cube square 450 -100 30 0 0 table 1.0)
        (facts (on-table square) (clear square) (arm-empty))))";

TEST(Judge, ACubeThatLeansCanBePickedUpSoThereIsAPlan) {
  const story::Judge judge = judge_for("blocks.scm");
  const story::WorldState truth = truth_of(leaning);
  const std::vector<Datum> facts = judge.facts(truth).value();
  EXPECT_TRUE(judge.plan_exists(goal_of("((on circle square))"), truth).value());
  EXPECT_TRUE(judge.plan_exists(goal_of("((on square circle))"), truth).value());
  EXPECT_FALSE(story::Judge::holds(goal_of("((on-table circle))"), facts));
}

TEST(Judge, ACubeThatLiesAskewOnAnotherCoversIt) {
  const story::Judge judge = judge_for("blocks.scm");
  const story::WorldState truth = truth_of(
      R"(((cube circle 450 -80 95 0 20 loose 1.0) (cube square 450 -100 30 0 0 table 1.0)
          (facts (on-table square) (clear square) (arm-empty))))");
  const std::vector<Datum> stood = judge.as_a_person_would_say(truth).value();
  EXPECT_EQ(write(Datum::list(stood)),
            "((arm-empty) (bare circle) (clear circle) (on circle square) (on-table square))");
  EXPECT_TRUE(judge.plan_exists(goal_of("((on square circle))"), truth).value());
}

TEST(Judge, ACubeThatFellOffTheTableHasNoPlan) {
  const story::Judge judge = judge_for("blocks.scm");
  const story::WorldState truth = truth_of(
      R"(((cube circle 900 -145 -400 0 35 loose 0.0) (cube square 450 -100 30 0 0 table 1.0)
          (facts (on-table square) (clear square) (arm-empty))))");
  EXPECT_FALSE(judge.plan_exists(goal_of("((on circle square))"), truth).value());
}

story::DirectorReport refused_with(const char* symbol) {
  story::DirectorReport report;
  report.outcome = "refused";
  report.refusal = Failure{symbol, "", {}, {}};
  report.possible = false;
  return report;
}

TEST(DirectorReport, ARefusalIsCorrectOnlyForAReasonInTheGoalOrTheWorld) {
  for (const char* symbol : {"no-plan", "missing-object"}) {
    story::DirectorReport report = refused_with(symbol);
    EXPECT_TRUE(report.refused_correctly()) << symbol;
    report.possible = true;
    EXPECT_FALSE(report.refused_correctly()) << symbol;
    report.blind = true;
    EXPECT_TRUE(report.refused_correctly()) << symbol;
  }
  for (const char* symbol : {"stopped", "timeout", "gave-up", "absent", "missed"}) {
    EXPECT_FALSE(refused_with(symbol).refused_correctly()) << symbol;
  }
  story::DirectorReport late = refused_with("no-plan");
  late.outcome = "timeout";
  EXPECT_FALSE(late.refused_correctly());
}

}  // namespace
}  // namespace pizarra::programs
