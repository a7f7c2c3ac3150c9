#include "drivers/arm/route.hpp"

#include <gtest/gtest.h>

#include "blackboard/time/random.hpp"
#include "drivers/arm/arm_file.hpp"

namespace pizarra::arm {
namespace {

const ArmModel& arm() { return crs_f3(); }

std::vector<Joints> waypoints_along(const std::vector<Eigen::Vector3d>& ways_mm, double step_mm) {
  std::vector<Joints> waypoints;
  Joints at = arm().ready;
  ToolPose pose = forward(arm(), at);
  for (const Eigen::Vector3d& way : ways_mm) {
    const ToolPose begin = pose;
    const int steps = static_cast<int>(way.norm() / step_mm);
    for (int i = 1; i <= steps; ++i) {
      pose.translation() = begin.translation() + way * i / steps;
      at = inverse(arm(), pose, at).value();
      waypoints.push_back(at);
    }
  }
  return waypoints;
}

TEST(Route, OneWaypointIsOneLegOfAllAxesInProportion) {
  Joints there = arm().ready;
  there[0] += 30;
  const std::vector<Leg> legs = legs_of(arm(), arm().ready, {there});
  ASSERT_EQ(legs.size(), 1u);
  EXPECT_FALSE(legs[0].straight);
  EXPECT_EQ(legs[0].to, there);
  EXPECT_NEAR(legs[0].seconds, 30.0 / 240, 1e-9);
}

TEST(Route, WaypointsInProportionAreOneLeg) {
  std::vector<Joints> waypoints;
  for (int i = 1; i <= 40; ++i) {
    waypoints.push_back(arm().ready);
    waypoints.back()[0] += i;
    waypoints.back()[3] -= 0.5 * i;
  }
  const std::vector<Leg> legs = legs_of(arm(), arm().ready, waypoints);
  ASSERT_EQ(legs.size(), 1u);
  EXPECT_FALSE(legs[0].straight);
}

TEST(Route, ALineOfTheToolIsOneStraightLegAndACornerBeginsAnother) {
  const std::vector<Joints> waypoints = waypoints_along({{0, 150, 0}, {0, 0, -100}}, 5);
  const std::vector<Leg> legs = legs_of(arm(), arm().ready, waypoints);
  ASSERT_EQ(legs.size(), 2u);
  EXPECT_TRUE(legs[0].straight);
  EXPECT_TRUE(legs[1].straight);
  EXPECT_EQ(legs[0].to, waypoints[29]);
  EXPECT_EQ(legs[1].to, waypoints.back());
}

TEST(Route, ThereAndBackIsNoLine) {
  const std::vector<Leg> legs = legs_of(arm(), arm().ready, waypoints_along({{0, 100, 0}, {0, -100, 0}}, 5));
  ASSERT_EQ(legs.size(), 2u);
}

// Whatever the waypoints, the legs end at the last, and every leg ends at one of them.
TEST(Route, LegsLeadThroughWaypointsToTheLast) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    Random random(seed);
    std::vector<Joints> waypoints;
    for (std::uint64_t i = 1 + random.below(30); i > 0; --i) {
      waypoints.push_back(waypoints.empty() ? arm().ready : waypoints.back());
      for (double& axis : waypoints.back()) axis += random.uniform(-1, 1) * (random.below(3) == 0 ? 1 : 0);
    }
    std::size_t next = 0;
    for (const Leg& leg : legs_of(arm(), arm().ready, waypoints)) {
      while (next < waypoints.size() && waypoints[next] != leg.to) ++next;
      ASSERT_LT(next, waypoints.size()) << "seed " << seed;
    }
    EXPECT_TRUE(are_same_place(waypoints[next], waypoints.back(), 1e-12)) << "seed " << seed;
  }
}

}  // namespace
}  // namespace pizarra::arm
