#include "blackboard/time/pace.hpp"

#include <gtest/gtest.h>
#include <vector>

#include "blackboard/time/virtual_executor.hpp"

namespace pizarra {
namespace {

// When the beats come, ms, each followed by work that takes as long as `work_ms` says.
std::vector<int> beats(const std::vector<int>& work_ms) {
  VirtualExecutor executor;
  const Time begun = executor.now();
  Pace pace(executor, 8ms);
  std::vector<int> out;
  for (const int work : work_ms) {
    executor.run_for(pace.pause());
    out.push_back(static_cast<int>((executor.now() - begun).count() / 1000));
    executor.run_for(work * 1ms);
  }
  return out;
}

TEST(Pace, WorkBetweenBeatsDoesNotSlowThemDown) { EXPECT_EQ(beats({3, 7, 0, 5}), (std::vector{8, 16, 24, 32})); }

TEST(Pace, OneLateBeatIsMadeUpFor) { EXPECT_EQ(beats({12, 0, 0}), (std::vector{8, 20, 24})); }

TEST(Pace, BeatsThatWereMissedAreLeftOut) { EXPECT_EQ(beats({100, 0, 0, 0}), (std::vector{8, 108, 108, 116})); }

}  // namespace
}  // namespace pizarra
