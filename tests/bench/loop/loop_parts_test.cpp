#include "tests/bench/loop/loop_parts.hpp"

#include <gtest/gtest.h>

namespace pizarra::bench {

TEST(LoopParts, AreMeasuredForAsManyObjectsAsTheImagesHold) {
  const std::optional<double> few = look_seconds(4);
  const std::optional<double> many = look_seconds(most_looked_at);
  ASSERT_TRUE(few && many);
  EXPECT_GT(*few, 0);
  EXPECT_GT(*many, *few);
  EXPECT_FALSE(look_seconds(most_looked_at + 1));
}

TEST(LoopParts, AreMeasuredForMoreObjectsThanEyesSee) {
  const PlanSeconds planner_s = plan_seconds(24, 4);
  EXPECT_GT(planner_s.choose, 0);
  EXPECT_GT(planner_s.plan, planner_s.choose);
}

}  // namespace pizarra::bench
