#include "lisp/pattern.hpp"

#include <gtest/gtest.h>

#include "lisp/reader.hpp"
#include "tests/lisp/random_datum.hpp"

namespace pizarra {
namespace {

Datum parse(std::string_view text) { return read_one(text).value(); }

TEST(PatternTest, BindsVariables) {
  Bindings bindings;
  ASSERT_TRUE(match(parse("(on ?x (at ?y 3))"), parse("(on circle (at \"b\" 3))"), bindings));
  EXPECT_EQ(*bindings.find("?x"), "circle"_sym);
  EXPECT_EQ(*bindings.find("?y"), to_datum("b"));
  EXPECT_EQ(bindings.find("?z"), nullptr);
}

TEST(PatternTest, OneVariableIsOneValue) {
  Bindings bindings;
  EXPECT_FALSE(match(parse("(on ?x ?x)"), parse("(on a b)"), bindings));
  EXPECT_EQ(bindings, Bindings());
  EXPECT_TRUE(match(parse("(on ?x ?x)"), parse("(on a a)"), bindings));
  EXPECT_FALSE(match(parse("(clear ?x)"), parse("(clear b)"), bindings));
  EXPECT_TRUE(match(parse("(clear ?x)"), parse("(clear a)"), bindings));
}

TEST(PatternTest, QuestionMarkAloneMatchesAnythingAndBindsNothing) {
  Bindings bindings;
  EXPECT_TRUE(match(parse("(on ? ?)"), parse("(on a (b c))"), bindings));
  EXPECT_EQ(bindings, Bindings());
}

TEST(PatternTest, KindsAndLengthsMustAgree) {
  Bindings bindings;
  EXPECT_FALSE(match(parse("(on a)"), parse("(on \"a\")"), bindings));
  EXPECT_FALSE(match(parse("(on 1)"), parse("(on 1.0)"), bindings));
  EXPECT_FALSE(match(parse("(on ?x)"), parse("(on a b)"), bindings));
  EXPECT_FALSE(match(parse("(on ?x)"), parse("on"), bindings));
}

TEST(PatternTest, SubstituteReplacesWhatIsBound) {
  Bindings bindings;
  bindings.bind("?x", "circle"_sym);
  EXPECT_EQ(substitute(parse("(on ?x (f ?y ?x))"), bindings), parse("(on circle (f ?y circle))"));
}

TEST(PatternTest, AMatchedPatternSubstitutesToTheDatum) {
  RandomDatum random(5);
  for (int i = 0; i < 1000; ++i) {
    const Datum datum = random.any(4);
    if (!is_ground(datum)) continue;
    std::vector<Datum> items(datum.items().begin(), datum.items().end());
    int next = 0;
    for (Datum& item : items) {
      if (random.below(2)) item = Datum::symbol("?v" + std::to_string(next++));
    }
    const Datum pattern = items.empty() ? datum : Datum::list(items);
    Bindings bindings;
    ASSERT_TRUE(match(pattern, datum, bindings));
    EXPECT_EQ(substitute(pattern, bindings), datum);
  }
}

}  // namespace
}  // namespace pizarra
