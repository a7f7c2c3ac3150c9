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

TEST(FlatPatternTest, MatchesWhatThePatternMatchesAndBindsTheSame) {
  RandomDatum random(6);
  constexpr const char* elements[] = {"a", "b", "1", "(a b)", "?", "?x", "?y", "?a", "()"};
  const auto some = [&](std::size_t kinds) {
    std::vector<Datum> items(random.below(4));
    for (Datum& item : items) item = parse(elements[random.below(kinds)]);
    return Datum::list(std::move(items));
  };
  int flat_and_fitting = 0;
  for (int i = 0; i < 20'000; ++i) {
    const Datum pattern = some(std::size(elements));
    const Datum datum = random.below(20) == 0 ? parse("a") : some(4);
    const std::optional<FlatPattern> flat = FlatPattern::of(pattern);
    if (!flat) continue;
    Bindings expected;
    const bool fits = match(pattern, datum, expected);
    const std::optional<Bindings> found = flat->match(datum);
    ASSERT_EQ(found.has_value(), fits);
    if (!fits) continue;
    ASSERT_EQ(*found, expected);
    ++flat_and_fitting;
  }
  EXPECT_GT(flat_and_fitting, 500);
}

TEST(FlatPatternTest, IsNoneWithAVariableTwiceOrInsideAList) {
  EXPECT_FALSE(FlatPattern::of(parse("(on ?x ?x)")));
  EXPECT_FALSE(FlatPattern::of(parse("(on (f ?x))")));
  EXPECT_FALSE(FlatPattern::of(parse("?x")));
  EXPECT_TRUE(FlatPattern::of(parse("(on ? ?)")));
}

}  // namespace
}  // namespace pizarra
