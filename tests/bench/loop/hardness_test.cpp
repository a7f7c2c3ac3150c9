#include "tests/bench/loop/hardness.hpp"

#include <gtest/gtest.h>

namespace pizarra::bench {

TEST(Hardness, IsEqualWithinTenPoints) {
  EXPECT_STREQ(hardness(31.7, 21.7), "equal");
  EXPECT_STREQ(hardness(11.7, 21.7), "equal");
}

TEST(Hardness, IsLessWhereOurOpenLoopReachesMore) {
  EXPECT_STREQ(hardness(40, 21.7), "easier");
  EXPECT_STREQ(hardness(0, 15), "harder");
}

}  // namespace pizarra::bench
