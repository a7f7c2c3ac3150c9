#include "lisp/weight.hpp"

#include <gtest/gtest.h>

#include "lisp/reader.hpp"
#include "lisp/writer.hpp"
#include "tests/lisp/random_datum.hpp"

namespace pizarra {
namespace {

// What weigh() says, found by looking at everything.
Weight weigh_anew(const Datum& datum) {
  Weight whole{.bytes = datum.is_list() ? std::size_t{3} : weigh(datum).bytes, .elements = 1};
  for (const Datum& item : datum.items()) whole += weigh_anew(item);
  if (datum.is_list()) ++whole.depth;
  return whole;
}

TEST(Weight, IsNeverLessThanTheTextAndCountsEveryElement) {
  RandomDatum random(7);
  for (int i = 0; i < 3000; ++i) {
    const Datum datum = random.any(5);
    const Weight weight = weigh(datum);
    ASSERT_GE(weight.bytes, write(datum).size()) << write(datum);
    ASSERT_EQ(weight, weigh_anew(datum)) << write(datum);
  }
}

TEST(Weight, IsTheSameWhenAskedAgainAndOfWhatSharesOrHoldsTheDatum) {
  RandomDatum random(8);
  for (int i = 0; i < 1000; ++i) {
    const Datum datum = random.any(4);
    const Weight weight = weigh(datum);
    const Datum copy = datum;
    ASSERT_EQ(weigh(datum), weight);
    ASSERT_EQ(weigh(copy), weight);
    ASSERT_EQ(weigh(list("holds"_sym, datum, 1)), weigh_anew(list("holds"_sym, datum, 1)));
  }
}

TEST(Weight, OfWhatIsTooDeepOrTooManyToRememberIsRightAsWell) {
  Datum deep = list("in"_sym);
  for (int depth = 1; depth < 300; ++depth) {
    ASSERT_EQ(weigh(deep).depth, depth);
    deep = list(deep);
  }
  EXPECT_EQ(weigh(deep).depth, 300);
  Datum wide = list(1, 2, 3, 4);
  for (int doubled = 0; doubled < 26; ++doubled) wide = list(wide, wide);
  EXPECT_EQ(weigh(wide).elements, (std::size_t{6} << 26) - 1);
}

}  // namespace
}  // namespace pizarra
