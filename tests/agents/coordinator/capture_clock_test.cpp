#include "agents/coordinator/perceive/capture_clock.hpp"

#include <gtest/gtest.h>

namespace pizarra::coordinator {
namespace {

// Five looks a second apart, each 20 ms on its way, of eyes whose clock is a minute behind the board's.
constexpr Duration behind = 60s;
CaptureClock known(Time first) {
  CaptureClock clock;
  for (int look = 0; look < 5; ++look) clock.on_board(first + look * 1s, first + look * 1s + behind + 20ms);
  return clock;
}

TEST(CaptureClock, SaysWhenAFrameWasCapturedOnTheBoardsClock) {
  CaptureClock clock = known(Time(100s));
  EXPECT_EQ(clock.on_board(Time(110s), Time(110s) + behind + 30ms), Time(110s) + behind + 20ms);
}

TEST(CaptureClock, DoesNotTakeALookForNewerThatWasLongOnItsWay) {
  CaptureClock clock = known(Time(100s));
  EXPECT_EQ(clock.on_board(Time(110s), Time(114s) + behind), Time(110s) + behind + 20ms);
}

TEST(CaptureClock, SaysNothingBeforeSomeLooksCame) {
  CaptureClock clock;
  EXPECT_FALSE(clock.on_board(Time(100s), Time(103s)));
}

TEST(CaptureClock, FollowsAClockThatIsSetForward) {
  CaptureClock clock = known(Time(100s));
  for (int look = 0; look < 30; ++look) clock.on_board(Time(110s) + look * 1s, Time(110s) + look * 1s + 20ms);
  EXPECT_EQ(clock.on_board(Time(200s), Time(200s) + 50ms), Time(200s) + 20ms);
}

}  // namespace
}  // namespace pizarra::coordinator
