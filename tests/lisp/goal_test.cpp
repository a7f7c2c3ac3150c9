#include "lisp/forms/goal.hpp"

#include <gtest/gtest.h>

#include "lisp/pattern.hpp"
#include "lisp/writer.hpp"

namespace pizarra {
namespace {

class GoalTest : public testing::Test {
 protected:
  GoalTest() {
    auto read = forms::read_domain(
        "(domain d (types OBJECT PLACE) (objects (place-1 PLACE))"
        " (predicates (on (upper OBJECT) (lower OBJECT)) (at (ob OBJECT) (where PLACE)) (arm-empty)))",
        "d.scm");
    domain_ = read.value();
  }

  std::string goal(std::string_view text) {
    const auto facts =
        forms::read_goal(domain_, text, {{"circle", "OBJECT"}, {"triangle", "OBJECT"}, {"End-Effector", "OBJECT"}});
    return facts ? write(Datum::list(*facts)) : facts.error().symbol;
  }

  forms::Domain domain_;
};

TEST_F(GoalTest, ThreeSpellingsAreOneGoal) {
  const std::string wanted = "((on circle triangle) (arm-empty))";
  EXPECT_EQ(goal("(on circle triangle) (arm-empty)"), wanted);
  EXPECT_EQ(goal("(and (on circle triangle) (arm-empty))"), wanted);
  EXPECT_EQ(goal("(AND (on circle triangle) (arm-empty))"), wanted);
  EXPECT_EQ(goal("(on CIRCLE \"triangle\")"), "((on circle triangle))");
  EXPECT_EQ(goal("(on end-effector triangle)"), "((on End-Effector triangle))");
  EXPECT_EQ(goal("(at circle place-1)"), "((at circle place-1))");
}

TEST_F(GoalTest, WhatIsWrongHasItsSymbol) {
  EXPECT_EQ(goal("(on circle"), "unclosed-list");
  EXPECT_EQ(goal(""), "malformed");
  EXPECT_EQ(goal("circle"), "malformed");
  EXPECT_EQ(goal("(in circle triangle)"), "unknown-predicate");
  EXPECT_EQ(goal("(on circle)"), "wrong-arity");
  EXPECT_EQ(goal("(on circle place-1)"), "wrong-type");
  EXPECT_EQ(goal("(on circle star)"), "unknown-object");
  EXPECT_EQ(goal("(on ?x triangle)"), "not-ground");
  EXPECT_EQ(goal("(and (arm-empty) (not (arm-empty)))"), "contradictory");
  EXPECT_EQ(goal("(not (arm-empty))"), "((not (arm-empty)))");
}

TEST_F(GoalTest, ARefusalIsShownAtTheFirstOfTheGoalsThatItNames) {
  const Datum together =
      list(list("on"_sym, "triangle"_sym, "circle"_sym), list("on"_sym, "circle"_sym, "triangle"_sym));
  const std::string text = "(and (arm-empty)\n     (on \"circle\" Triangle)\n (on triangle circle))";
  EXPECT_EQ(forms::at_its_goal({"no-plan", "never", together, {}}, text).place,
            "goal:2:6\n"
            "       (on \"circle\" Triangle)\n"
            "       ^");
  EXPECT_EQ(forms::at_its_goal({"missing-object", "not seen", "circle"_sym, {}}, "(on triangle circle)").place,
            "goal:1:14\n"
            "  (on triangle circle)\n"
            "               ^");
}

TEST_F(GoalTest, ARefusalThatNamesNothingOfTheGoalHasAPlaceWhereItIsAboutTheWholeGoal) {
  const std::string text = "(on triangle circle)";
  EXPECT_EQ(forms::at_its_goal({"no-plan", "never", {}, {}}, text).place, "goal:1:1\n  (on triangle circle)\n  ^");
  EXPECT_EQ(forms::at_its_goal({"absent", "the arm is gone", "robot"_sym, {}}, text).place, "");
  EXPECT_EQ(forms::at_its_goal({"no-plan", "never", {}, "elsewhere"}, text).place, "elsewhere")
      << "one that has its place";
}

TEST_F(GoalTest, AnUnknownObjectIsShownWithACaret) {
  const auto facts =
      forms::read_goal(domain_, "(and (on circle traingle))", {{"circle", "OBJECT"}, {"triangle", "OBJECT"}});
  ASSERT_FALSE(facts);
  EXPECT_EQ(facts.error().subject, "traingle"_sym);
  EXPECT_EQ(describe(facts.error()),
            "nothing is called traingle; the nearest is triangle\n"
            "goal:1:17\n"
            "  (and (on circle traingle))\n"
            "                  ^\n"
            "  in the goal (and ...)");
}

// The board holds no ?x, so that requests have <x> in its place.
TEST_F(GoalTest, AVariableIsShownAsPeopleTypeIt) {
  const Datum counted =
      list("at-least"_sym, "two"_sym, list("<x>"_sym, "OBJECT"_sym), list("at"_sym, "<x>"_sym, "place-1"_sym));
  const auto facts = forms::goal_from_data(domain_, {counted}, {});
  ASSERT_FALSE(facts);
  EXPECT_EQ(describe(facts.error()),
            "it is written (at-least NUMBER (?x TYPE) GOAL), the number from 1\n"
            "goal:1:1\n"
            "  (at-least two (?x OBJECT) (at ?x place-1))\n"
            "  ^");
  const auto free = forms::goal_from_data(domain_, {list("on"_sym, "<y>"_sym, "circle"_sym)}, {{"circle", "OBJECT"}});
  ASSERT_FALSE(free);
  EXPECT_EQ(describe(free.error()),
            "a goal names objects, and ?y is a variable\n"
            "goal:1:5\n"
            "  (on ?y circle)\n"
            "      ^");
}

TEST_F(GoalTest, ARefusalOfAGoalWithVariablesCrossesTheBoard) {
  const auto free = forms::goal_from_data(domain_, {list("on"_sym, "<y>"_sym, "circle"_sym)}, {{"circle", "OBJECT"}});
  ASSERT_FALSE(free);
  EXPECT_TRUE(is_ground(free.error().subject));
}

TEST_F(GoalTest, BeforeAnythingIsSeenOnlyNamesAreOpen) {
  EXPECT_EQ(write(Datum::list(forms::check_goal(domain_, "(on Star place-2)").value())), "((on Star place-2))");
  EXPECT_EQ(forms::check_goal(domain_, "(on Star)").error().symbol, "wrong-arity");
  EXPECT_EQ(forms::check_goal(domain_, "(on Star place-1)").error().symbol, "wrong-type");
}

}  // namespace
}  // namespace pizarra
