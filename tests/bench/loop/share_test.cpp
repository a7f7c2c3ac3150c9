#include "tests/bench/loop/share.hpp"

#include <gtest/gtest.h>

namespace pizarra::bench {

TEST(Share, IsSurerTheMoreRunsThereAre) {
  const Share few = share_of(9, 10);
  EXPECT_NEAR(few.low, 59.6, 0.1);
  EXPECT_NEAR(few.high, 98.2, 0.1);
  const Share many = share_of(900, 1000);
  EXPECT_NEAR(many.low, 88.0, 0.1);
  EXPECT_NEAR(many.high, 91.7, 0.1);
}

TEST(Share, OfAllOrNoneIsNotCertain) {
  EXPECT_NEAR(share_of(300, 300).low, 98.7, 0.1);
  EXPECT_NEAR(share_of(300, 300).high, 100, 1e-9);
  EXPECT_NEAR(share_of(0, 300).low, 0, 1e-9);
  EXPECT_NEAR(share_of(0, 300).high, 1.3, 0.1);
}

TEST(Share, OfNothingIsUnknown) { EXPECT_EQ(share_of(0, 0).high, 100); }

}  // namespace pizarra::bench
