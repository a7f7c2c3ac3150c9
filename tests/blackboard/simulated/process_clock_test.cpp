// What a process of a simulated run takes for the time.

#include <gtest/gtest.h>

#include "blackboard/simulated/process.hpp"
#include "blackboard/time/virtual_executor.hpp"

namespace pizarra::simulated {
namespace {

class ProcessClock : public testing::Test {
 protected:
  // Of the shared time, once the process has slept for so long by its own clock; `meanwhile` is done after 1 s.
  Duration sleeps(Duration length, Callback meanwhile) {
    const Time begun = time_.now();
    std::optional<Duration> woken;
    process_.call_at(process_.now() + length, [&] { woken = time_.now() - begun; });
    time_.call_at(begun + 1s, std::move(meanwhile));
    time_.run_until([&] { return woken.has_value(); });
    return woken.value_or(Duration::zero());
  }
  // Not before it has gone on.
  void suspend_for(Duration length) {
    process_.suspend();
    time_.call_at(time_.now() + length, [this] { process_.resume(); });
  }

  VirtualExecutor time_;
  Process process_{time_, {.ahead = 5s}};
};

TEST_F(ProcessClock, GoesOnSteadily) {
  EXPECT_EQ(sleeps(4s, [] {}), 4s);
  EXPECT_EQ(process_.now() - time_.now(), 5s);
}

TEST_F(ProcessClock, ThatJumpsAheadMakesWhatWaitsDueEarlier) {
  EXPECT_EQ(sleeps(4s, [this] { process_.jump(2s); }), 2s);
  EXPECT_EQ(process_.now() - time_.now(), 7s);
  EXPECT_EQ(sleeps(4s, [this] { process_.jump(9s); }), 1s);
}

TEST_F(ProcessClock, StandsWhileTheHostIsSuspendedAndIsBehindFromThenOn) {
  EXPECT_EQ(sleeps(4s, [this] { suspend_for(10s); }), 14s);
  EXPECT_EQ(process_.now() - time_.now(), -5s);
}

TEST_F(ProcessClock, DoesNotGoOnBeforeTheHostDoes) {
  suspend_for(3s);
  const Time stands = process_.now();
  time_.run_for(2s);
  EXPECT_EQ(process_.now(), stands);
  time_.run_for(2s);
  EXPECT_EQ(process_.now(), stands + 1s);
}

TEST_F(ProcessClock, GoesOnWhileTheProcessAloneIsHeldUp) {
  const auto hold = [this] {
    process_.pause();
    time_.call_at(time_.now() + 10s, [this] { process_.resume(); });
  };
  EXPECT_EQ(sleeps(4s, hold), 11s);
  EXPECT_EQ(process_.now() - time_.now(), 5s);
}

}  // namespace
}  // namespace pizarra::simulated
