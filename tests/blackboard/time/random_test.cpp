#include "blackboard/time/random.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <map>

namespace pizarra {
namespace {

TEST(Random, RepeatsForASeedAndDiffersBetweenSeeds) {
  Random a(7), b(7), c(8);
  for (int i = 0; i < 100; ++i) {
    const auto drawn = a.bits();
    EXPECT_EQ(drawn, b.bits());
    EXPECT_NE(drawn, c.bits());
  }
}

TEST(Random, ASplitStreamIsNotDisturbedByItsParent) {
  Random parent(7);
  Random before = parent.split("camera");
  parent.bits();
  Random after = parent.split("camera");
  EXPECT_EQ(before.bits(), after.bits());
  EXPECT_NE(parent.split("camera").bits(), parent.split("hand").bits());
}

TEST(Random, BelowIsEvenAndInRange) {
  Random random(3);
  std::map<std::uint64_t, int> counts;
  for (int i = 0; i < 70'000; ++i) ++counts[random.below(7)];
  ASSERT_EQ(counts.size(), 7u);
  EXPECT_EQ(counts.rbegin()->first, 6u);
  for (const auto& [value, count] : counts) EXPECT_NEAR(count, 10'000, 500) << value;
}

TEST(Random, UniformAndNormalHaveTheirMoments) {
  Random random(5);
  double sum = 0, normal_sum = 0, normal_squares = 0;
  constexpr int draws = 100'000;
  for (int i = 0; i < draws; ++i) {
    const double u = random.uniform(-1, 3);
    ASSERT_GE(u, -1);
    ASSERT_LT(u, 3);
    sum += u;
    const double n = random.normal();
    normal_sum += n;
    normal_squares += n * n;
  }
  EXPECT_NEAR(sum / draws, 1.0, 0.02);
  EXPECT_NEAR(normal_sum / draws, 0.0, 0.02);
  EXPECT_NEAR(normal_squares / draws, 1.0, 0.03);
}

}  // namespace
}  // namespace pizarra
