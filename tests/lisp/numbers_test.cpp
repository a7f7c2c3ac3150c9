#include "lisp/numbers.hpp"

#include <gtest/gtest.h>

namespace pizarra {
namespace {

TEST(Numbers, AreRoundedToTheNearestOfSoManyPartsOfOne) {
  EXPECT_EQ(rounded(0.126, 100), 0.13);
  EXPECT_EQ(rounded(-12.34, 10), -12.3);
  EXPECT_EQ(rounded(7, 1000), 7);
}

TEST(Numbers, AreNeverRoundedToANegativeZero) {
  EXPECT_FALSE(std::signbit(rounded(-0.0001, 100)));
  EXPECT_FALSE(std::signbit(rounded(-0.0, 100)));
}

TEST(Numbers, OfDegreesAndRadiansAreTurnedIntoEachOther) {
  EXPECT_DOUBLE_EQ(radians(180), std::numbers::pi);
  EXPECT_DOUBLE_EQ(degrees(-std::numbers::pi / 2), -90);
}

}  // namespace
}  // namespace pizarra
