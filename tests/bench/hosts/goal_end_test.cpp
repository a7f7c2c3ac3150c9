#include "tests/bench/hosts/goal_end.hpp"

#include <gtest/gtest.h>

namespace pizarra::bench {
namespace {

constexpr int refused = programs::exit_refused;

TEST(GoalEnd, IsReachedWhereTheWorldShowsItAlone) {
  EXPECT_EQ(verdict_of({.status = 0, .world_has_it = true}), GoalVerdict::reached);
  EXPECT_EQ(verdict_of({.status = 0}), GoalVerdict::failed);
}

TEST(GoalEnd, IsARightRefusalWhereACubeIsGone) {
  EXPECT_EQ(verdict_of({.status = refused, .cube_is_gone = true}), GoalVerdict::refused_correctly);
  EXPECT_EQ(verdict_of({.status = refused}), GoalVerdict::failed);
}

TEST(GoalEnd, IsARightRefusalByALossThatHadHappened) {
  GoalEnd end{.status = refused, .nobody_would_pursue = true, .lost_the_coordinator = true};
  EXPECT_EQ(verdict_of(end), GoalVerdict::refused_correctly);
  end.ended_before_the_loss = true;
  EXPECT_EQ(verdict_of(end), GoalVerdict::failed) << "nothing was lost yet";
  end = {.status = refused, .nobody_would_pursue = true};
  EXPECT_EQ(verdict_of(end), GoalVerdict::failed) << "the coordinator was there";
}

}  // namespace
}  // namespace pizarra::bench
