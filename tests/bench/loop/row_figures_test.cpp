#include "tests/bench/loop/row_figures.hpp"

#include <gtest/gtest.h>

namespace pizarra::bench {

TEST(RowFigures, CountsTheGripsAtWhichACubeMovedAndTheirRuns) {
  Runs runs(3);
  runs[0].grips_mm_s = {48, 0, 50};
  runs[1].grips_mm_s = {0, 1};
  runs[2].grips_mm_s = {49};
  const MovingGrips moving = moving_grips(runs, 25);
  EXPECT_EQ(moving.grips, 3);
  EXPECT_EQ(moving.of_grips, 6);
  EXPECT_EQ(moving.runs, 2);
  EXPECT_EQ(moving.median_mm_s, 49);
  EXPECT_EQ(moving_grips({}, 25).runs, 0);
}

TEST(RowFigures, TakesTheTimeOfTheRunsThatReachedTheirGoal) {
  Runs runs(3);
  runs[0].reached = runs[1].reached = true;
  runs[0].took_s = 10;
  runs[1].took_s = 20;
  runs[2].took_s = 400;
  EXPECT_EQ(reached(runs), 2);
  EXPECT_EQ(mean_time_s(runs), 15);
}

}  // namespace pizarra::bench
