#include "tests/bench/cluster/awaited.hpp"

#include <gtest/gtest.h>

namespace pizarra::bench {
namespace {

constexpr std::size_t nobody = 3;

TEST(AwaitedLeader, IsTheFirstOneThatIsFoundDuringAnElection) {
  std::size_t looked = 0;
  const auto who = [&] { return ++looked < 3 ? nobody : 1; };
  EXPECT_EQ(awaited(who, nobody, "nobody leads", std::chrono::seconds(60)), 1u);
  EXPECT_EQ(looked, 3u);
}

TEST(AwaitedLeader, ThatNeverComesEndsTheBenchInsteadOfARoundWithoutAKill) {
  const auto who = [] { return nobody; };
  EXPECT_THROW(awaited(who, nobody, "nobody leads", std::chrono::milliseconds(1)), std::runtime_error);
}

}  // namespace
}  // namespace pizarra::bench
