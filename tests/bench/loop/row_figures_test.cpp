#include "tests/bench/loop/row_figures.hpp"

#include <gtest/gtest.h>

namespace pizarra::bench {

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
