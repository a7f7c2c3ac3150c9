#include "lisp/forms/goal_formula.hpp"

#include <gtest/gtest.h>

#include "lisp/reader.hpp"
#include "lisp/writer.hpp"

namespace pizarra::forms {
namespace {

std::vector<Datum> all(std::string_view text) {
  const Datum read = read_one(text).value();
  return {read.items().begin(), read.items().end()};
}

const TypedObjects three{{"a", "OBJECT"}, {"b", "OBJECT"}, {"c", "OBJECT"}, {"left", "PLACE"}};

std::string ways(std::string_view goal, const TypedObjects& objects = three) {
  const Result<std::vector<GoalLiterals>> found = goal_alternatives(all(goal), objects);
  if (!found) return found.error().symbol;
  std::vector<Datum> lists;
  for (const GoalLiterals& way : *found) lists.push_back(Datum::list(way));
  return write(Datum::list(std::move(lists)));
}

bool holds(std::string_view goal, std::string_view facts) {
  const std::vector<Datum> holding = all(facts);
  return goal_holds(all(goal), {holding.begin(), holding.end()}, three);
}

}  // namespace

TEST(GoalFormula, FactsAloneAreOneWayInTheirOrder) { EXPECT_EQ(ways("((on b c) (on a b))"), "(((on b c) (on a b)))"); }

TEST(GoalFormula, EitherIsTwoWaysAndWhatGoesBeyondAnotherIsNone) {
  EXPECT_EQ(ways("((or (on a b) (on b a)))"), "(((on a b)) ((on b a)))");
  EXPECT_EQ(ways("((or (on a b) (and (on a b) (on b c))))"), "(((on a b)))");
}

TEST(GoalFormula, NegationsGoInwards) {
  EXPECT_EQ(ways("((not (or (on a b) (not (on-table c)))))"), "(((not (on a b)) (on-table c)))");
  EXPECT_EQ(ways("((not (not (on a b))))"), "(((on a b)))");
}

TEST(GoalFormula, AContradictionIsNoWay) {
  EXPECT_EQ(ways("((on a b) (not (on a b)))"), "()");
  EXPECT_EQ(ways("((or (on c a) (and (on a b) (not (on a b)))))"), "(((on c a)))");
}

TEST(GoalFormula, QuantifiersAreOverTheObjectsOfTheirType) {
  EXPECT_EQ(ways("((forall (<x> OBJECT) (on-table <x>)))"), "(((on-table a) (on-table b) (on-table c)))");
  EXPECT_EQ(ways("((exists (<x> PLACE) (at a <x>)))"), "(((at a left)))");
  EXPECT_EQ(ways("((forall (<x> NOTHING) (on-table <x>)))"), "(())") << "of nothing, everything is so";
  EXPECT_EQ(ways("((exists (<x> NOTHING) (on-table <x>)))"), "()");
  EXPECT_EQ(ways("((exists (<x> OBJECT) (and (not (= <x> a)) (on <x> a))))"), "(((on b a)) ((on c a)))");
}

TEST(GoalFormula, AGoalIsAboutAllObjectsOfATypeOrSomeOrNone) {
  const auto over = [](std::string_view goal) { return quantified_over(all(goal), "OBJECT"); };
  for (const std::string_view goal :
       {"((forall (<x> OBJECT) (on-table <x>)))", "((not (exists (<x> OBJECT) (on <x> a))))",
        "((not (at-least 2 (<x> OBJECT) (on-table <x>))))",
        "((on a b) (or (on b a) (forall (<x> OBJECT) (clear <x>))))",
        "((exists (<p> PLACE) (not (exists (<x> OBJECT) (at <x> <p>)))))"}) {
    EXPECT_EQ(over(goal), Quantified::all) << goal;
  }
  for (const std::string_view goal :
       {"((exists (<x> OBJECT) (on <x> a)))", "((at-least 2 (<x> OBJECT) (on-table <x>)))",
        "((not (forall (<x> OBJECT) (on-table <x>))))", "((forall (<p> PLACE) (exists (<x> OBJECT) (at <x> <p>))))"}) {
    EXPECT_EQ(over(goal), Quantified::some) << goal;
  }
  for (const std::string_view goal : {"((on a b))", "((not (on a b)))", "((forall (<p> PLACE) (at a <p>)))"}) {
    EXPECT_EQ(over(goal), Quantified::none) << goal;
  }
}

TEST(GoalFormula, SoManyOfThemAreAnyOfThem) {
  EXPECT_EQ(ways("((at-least 2 (<x> OBJECT) (on-table <x>)))"),
            "(((on-table a) (on-table b)) ((on-table a) (on-table c)) ((on-table b) (on-table c)))");
  EXPECT_EQ(ways("((at-least 4 (<x> OBJECT) (on-table <x>)))"), "()");
  EXPECT_EQ(ways("((not (at-least 2 (<x> OBJECT) (on-table <x>))))"),
            "(((not (on-table a)) (not (on-table b))) ((not (on-table a)) (not (on-table c))) "
            "((not (on-table b)) (not (on-table c))))");
}

TEST(GoalFormula, TooManyWaysAreRefusedSoon) {
  TypedObjects many;
  for (int i = 0; i < 60; ++i) many.emplace_back("ob-" + std::to_string(i), "OBJECT");
  EXPECT_EQ(ways("((at-least 30 (<x> OBJECT) (on-table <x>)))", many), "too-many");
}

TEST(GoalFormula, HoldsAsItsWaysDo) {
  EXPECT_TRUE(holds("((at-least 2 (<x> OBJECT) (on-table <x>)))", "((on-table a) (on-table c))"));
  EXPECT_FALSE(holds("((at-least 2 (<x> OBJECT) (on-table <x>)))", "((on-table a))"));
  EXPECT_TRUE(holds("((forall (<x> OBJECT) (exists (<y> OBJECT) (or (= <x> <y>) (on <x> <y>)))))", "()"));
  EXPECT_FALSE(holds("((not (on a b)))", "((on a b))"));
  EXPECT_EQ(unmet_parts(all("((on a b) (or (on b c) (on c b)))"), {read_one("(on a b)").value()}, three),
            all("((or (on b c) (on c b)))"));
}

TEST(GoalFormula, MoreObjectsOfATypeThanThereAreLeaveNoWay) {
  const auto few = [](std::string_view goal) { return too_few_objects(all(goal), three); };
  const std::optional<TooFewObjects> four = few("((on a b) (and (on b c) (at-least 4 (<x> OBJECT) (on-table <x>))))");
  ASSERT_TRUE(four);
  EXPECT_EQ(write(four->part), "(at-least 4 (<x> OBJECT) (on-table <x>))");
  EXPECT_EQ(four->type, "OBJECT");
  EXPECT_EQ(four->wanted, 4U);
  EXPECT_EQ(four->there, 3U);
  EXPECT_EQ(few("((exists (<x> ROBOT) (idle <x>)))")->there, 0U);
  EXPECT_FALSE(few("((at-least 3 (<x> OBJECT) (on-table <x>)) (exists (<x> PLACE) (at a <x>)))"));
  EXPECT_FALSE(few("((not (at-least 4 (<x> OBJECT) (on-table <x>))) (forall (<x> ROBOT) (idle <x>)))"));
}

TEST(GoalFormula, NamesItsObjectsAndNoVariables) {
  EXPECT_EQ(objects_in(all("((on a b) (exists (<x> OBJECT) (or (on <x> c) (not (on b a)))))")),
            (std::vector<std::string>{"a", "b", "c"}));
  EXPECT_EQ(write(without_variables(read_one("(forall (?x OBJECT) (on ?x a))").value())),
            "(forall (<x> OBJECT) (on <x> a))");
}

}  // namespace pizarra::forms
