#include "tests/bench/loop/loop_play.hpp"

#include <algorithm>
#include <gtest/gtest.h>

namespace pizarra::bench {

TEST(LoopPlay, AnUndisturbedTowerIsBuiltWithOpenAndClosedEyes) {
  const Played closed = play_loop({}, 1, false);
  EXPECT_TRUE(closed.reached) << closed.end;
  EXPECT_TRUE(closed.decisions_s.empty());
  EXPECT_EQ(closed.carries_s.size(), 2U);
  const Played open = play_loop({}, 1, true);
  EXPECT_TRUE(open.reached) << open.end;
}

TEST(LoopPlay, TheOpenLoopDoesNotNoticeASlipAndTheClosedOneDoes) {
  // Certain, and while the cube hangs high.
  const Disturbance slips{.slip_chance = 1, .slip_draws = 1, .slip_within_s = 1};
  const Played open = play_loop(slips, 1, true);
  EXPECT_FALSE(open.reached);
  EXPECT_EQ(open.end, "reached, but not so in the world");
  const Played closed = play_loop({.slip_chance = 0.5, .slip_draws = 1}, 3, false);
  EXPECT_TRUE(closed.reached) << closed.end;
}

TEST(LoopPlay, ACubeThatSlidesAtTheGripMovesAsTheFingersCloseAndIsGrippedLater) {
  const Played sliding = play_loop({.slide_mm_s = 50, .at_the_grip = true}, 1, false);
  EXPECT_TRUE(sliding.reached) << sliding.end;
  EXPECT_GT(std::ranges::count_if(sliding.grips_mm_s, [](double speed) { return speed > 40; }), 0);
  const Played at_rest = play_loop({}, 1, false);
  EXPECT_EQ(at_rest.grips_mm_s.size(), 2U);
  EXPECT_LT(std::ranges::max(at_rest.grips_mm_s), 1);
}

TEST(LoopPlay, TheSameSeedGivesTheSameRun) {
  const Disturbance disturbance{.slip_chance = 0.3, .misplace = 0.5, .moved = true};
  const Played first = play_loop(disturbance, 5, false);
  const Played again = play_loop(disturbance, 5, false);
  EXPECT_EQ(first.took_s, again.took_s);
  EXPECT_EQ(first.end, again.end);
  EXPECT_EQ(played_from_text(played_to_text(first)).took_s, first.took_s);
}

}  // namespace pizarra::bench
