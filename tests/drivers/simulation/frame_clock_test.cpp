#include "drivers/simulation/frame_clock.hpp"

#include <gtest/gtest.h>

namespace pizarra::simulation {
namespace {

constexpr Time born{std::chrono::seconds(5)};

TEST(FrameClock, TakesEachFrameAtItsStepWhateverTheRate) {
  for (const int rate : {10, 20, 30, 40, 60}) {
    const FrameClock clock(born, rate);
    for (std::uint64_t frame = 1; frame <= 1000; ++frame) {
      const Time taken = clock.frame_time(frame);
      EXPECT_EQ(clock.steps_until(taken), clock.frame_step(frame)) << rate << " Hz, frame " << frame;
      EXPECT_LT(clock.steps_until(taken - Duration(1)), clock.frame_step(frame)) << rate << " Hz, frame " << frame;
    }
    EXPECT_EQ(clock.frame_time(static_cast<std::uint64_t>(rate)), born + 1s);
  }
}

TEST(FrameClock, GivesEachFrameOnceToWhoAsksForTheNext) {
  const FrameClock clock(born, 30);
  Time last{};
  for (std::uint64_t frame = 1; frame <= 100; ++frame) {
    const std::uint64_t next = clock.next_frame(last == Time() ? born : last, last);
    ASSERT_EQ(next, frame);
    last = clock.frame_time(next);
  }
}

TEST(FrameClock, LeavesOutTheFramesThatArePast) {
  const FrameClock clock(born, 60);
  EXPECT_EQ(clock.next_frame(born + 1s + Duration(1), born), 61U);
}

TEST(FrameClock, KeepsNoRateThatFallsBetweenSteps) {
  EXPECT_FALSE(FrameClock::keeps(50));
  EXPECT_FALSE(FrameClock::keeps(0));
  EXPECT_FALSE(FrameClock::keeps(24));
  EXPECT_TRUE(FrameClock::keeps(60));
}

}  // namespace
}  // namespace pizarra::simulation
