// Where a head turns to show the table beside the image.

#include "agents/coordinator/geometry/head_views.hpp"

#include <algorithm>
#include <gtest/gtest.h>

#include "lisp/reader.hpp"

namespace pizarra::coordinator {
namespace {

constexpr double cube_half_mm = 30;
const HeadRange wide{-159, 159, -47, 31};
const HeadCamera standing{{{1330, 0, 200}, 0, 0}, {}};

std::vector<Eigen::Vector3d> table() { return table_within({}, Eigen::Vector3d::Zero(), standing); }

std::size_t shown(const std::vector<Eigen::Vector3d>& points, const std::vector<HeadTurn>& turns,
                  double around_mm = cube_half_mm) {
  const auto is_shown = [&](const Eigen::Vector3d& point) {
    return std::ranges::any_of(turns, [&](const HeadTurn& turn) {
      return CameraView(standing.pose, standing.model, turn).shows(point, around_mm);
    });
  };
  return static_cast<std::size_t>(std::ranges::count_if(points, is_shown));
}

TEST(HeadViews, ShowNearlyAllOfTheTableThatTheRestingCamerasDoNotShow) {
  const std::vector<Eigen::Vector3d> points = table();
  std::vector<HeadTurn> turns = {{}};
  EXPECT_LT(shown(points, turns), points.size() * 8 / 10);
  const std::vector<HeadTurn> views = views_of(standing, wide, {}, points, cube_half_mm);
  EXPECT_LE(views.size(), 6U);
  turns.insert(turns.end(), views.begin(), views.end());
  EXPECT_GT(shown(points, turns), points.size() * 95 / 100);
}

TEST(HeadViews, LookAheadAgainWhereTheHeadIsTurnedAway) {
  const Eigen::Vector3d ahead(480, 0, 30);
  const std::vector<HeadTurn> views = views_of(standing, wide, {.pan_deg = 60, .tilt_deg = 0}, table(), cube_half_mm);
  EXPECT_EQ(shown({ahead}, views), 1U);
}

TEST(HeadViews, KeepWithinTheLimitsOfTheUnit) {
  const HeadRange narrow{-5, 9, -4, 4};
  for (const HeadTurn& turn : views_of(standing, narrow, {}, table(), cube_half_mm)) {
    EXPECT_GE(turn.pan_deg, narrow.pan_low_deg);
    EXPECT_LE(turn.pan_deg, narrow.pan_high_deg);
    EXPECT_GE(turn.tilt_deg, narrow.tilt_low_deg);
    EXPECT_LE(turn.tilt_deg, narrow.tilt_high_deg);
  }
}

TEST(HeadViews, AreNoneOfAUnitThatCannotTurn) {
  EXPECT_TRUE(views_of(standing, {0, 0, 0, 0}, {}, table(), cube_half_mm).empty());
}

TEST(HeadViews, ShowLargeCubesWhole) {
  constexpr double large_half_mm = 60;
  ElbowRoom room;
  room.cube_mm = 2 * large_half_mm;
  const std::vector<Eigen::Vector3d> points = table_within(room, Eigen::Vector3d::Zero(), standing);
  const auto part_shown = [&](double around_mm) {
    std::vector<HeadTurn> turns = views_of(standing, wide, {}, points, around_mm);
    turns.emplace_back();
    return static_cast<double>(shown(points, turns, large_half_mm)) / static_cast<double>(points.size());
  };
  EXPECT_LT(part_shown(cube_half_mm), part_shown(large_half_mm));
  EXPECT_GT(part_shown(large_half_mm), 0.9);
}

TEST(HeadViews, TurnAsLittleAsShowsAllObjectsTogether) {
  const std::vector<Eigen::Vector3d> marks = {{480, -320, 30}, {480, 50, 30}};
  const std::optional<HeadTurn> turn = turn_that_shows(standing, wide, marks, 45);
  ASSERT_TRUE(turn);
  EXPECT_EQ(shown(marks, {*turn}), 2U);
  EXPECT_EQ(turn->tilt_deg, 0);
  EXPECT_LT(turn->pan_deg, 0);
  EXPECT_GT(turn->pan_deg, -20);
}

TEST(HeadViews, CannotShowObjectsThatStandTooFarApart) {
  EXPECT_FALSE(turn_that_shows(standing, wide, {{430, -430, 30}, {430, 430, 30}}, 45));
}

TEST(HeadRange, IsReadFromTheUnitsFactAndRefusedWhereItIsNone) {
  const auto range_of = [](std::string_view fact) { return head_range_from_fact(read_one(fact).value()); };
  const Result<HeadRange> range = range_of("(pan-tilt-unit (-159 158 0.05 300) (-47 31 0.05 300))");
  ASSERT_TRUE(range);
  EXPECT_EQ(range->pan_high_deg, 158);
  EXPECT_EQ(range->tilt_low_deg, -47);
  for (const char* bad : {"(pan-tilt-unit () ())", "(pan-tilt-unit (5 -5 1 1) (0 1 1 1))", "(head 1 2 still)",
                          "(pan-tilt-unit (a b 1 1) (0 1 1 1))"}) {
    EXPECT_FALSE(range_of(bad)) << bad;
  }
}

}  // namespace
}  // namespace pizarra::coordinator
