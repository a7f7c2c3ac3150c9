// Lines about an etcd that is away: soon, and few.

#include "blackboard/cluster/troubles.hpp"

#include <gtest/gtest.h>

namespace pizarra::cluster {
namespace {

class TroublesOfADay : public testing::Test {
 protected:
  void note(const Result<void>& result) {
    now_ += 100ms;
    if (std::optional<std::string> line = troubles_.news(result, now_)) lines_.push_back(std::move(*line));
  }
  static Result<void> away(int member) {
    return fail("unavailable", "the member 10.0.0." + std::to_string(member) + ": no route");
  }

  static constexpr int looks = 24 * 3600 * 10;
  Troubles troubles_;
  Time now_{1000s};
  std::vector<std::string> lines_;
};

TEST_F(TroublesOfADay, AreAFewLinesWhereMembersTakeTurns) {
  for (int look = 0; look < looks; ++look) note(away(look % 3));
  EXPECT_GT(lines_.size(), 5u);
  EXPECT_LT(lines_.size(), 50u);
  lines_.clear();
  for (int look = 0; look < 20; ++look) note({});
  EXPECT_EQ(lines_, (std::vector<std::string>{"the log answers again"}));
}

TEST_F(TroublesOfADay, AreBoundedWhereTheyComeAndGo) {
  for (int look = 0; look < looks; ++look) note(look % 2 == 0 ? away(1) : Result<void>());
  EXPECT_GT(lines_.size(), 100u);
  EXPECT_LT(lines_.size(), 3000u);
}

TEST_F(TroublesOfADay, AreSaidAtOnceAndAgainTheNextTime) {
  for (int time = 0; time < 5; ++time) {
    lines_.clear();
    note(away(1));
    note({});
    for (int look = 0; look < looks / 24; ++look) note({});
    EXPECT_EQ(lines_.size(), 2u) << time;
  }
}

}  // namespace
}  // namespace pizarra::cluster
