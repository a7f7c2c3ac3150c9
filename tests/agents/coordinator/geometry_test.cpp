#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "agents/coordinator/act/aim.hpp"
#include "agents/coordinator/geometry/camera_view.hpp"
#include "agents/coordinator/geometry/elbow_room.hpp"
#include "agents/coordinator/geometry/free_spot.hpp"
#include "agents/coordinator/geometry/sight_lines.hpp"
#include "blackboard/time/random.hpp"
#include "lisp/guile/scheme.hpp"

namespace pizarra::coordinator {
namespace {

// As looks are placed.
Eigen::Vector3d placed(const CameraView& view, const Sight& sight) {
  const Result<Datum> at = guile::call_scheme(
      "looks", "place", {view.numbers(), to_datum(sight.x_px), to_datum(sight.y_px), to_datum(sight.range_mm)});
  return at ? Eigen::Vector3d((*at)[0].number(), (*at)[1].number(), (*at)[2].number()) : Eigen::Vector3d::Zero();
}

TEST(CameraView, SeesRightAsPlusYAndAwayAsTowardsTheArm) {
  const CameraView view({}, {});
  EXPECT_NEAR(view.right().y(), 1, 1e-9);
  EXPECT_NEAR(view.away().x(), -1, 1e-9);
}

TEST(CameraView, MeasuresARangeNotADepth) {
  const CameraView view({}, {});
  const Sight sight = view.sight({480, 200, 200});
  EXPECT_NEAR(sight.depth_mm, 850, 1e-9);
  EXPECT_NEAR(sight.range_mm, std::hypot(850.0, 200.0), 1e-9);
  EXPECT_NEAR(sight.y_px, 119.5, 1e-9);
  EXPECT_NEAR(sight.x_px, 159.5 + 431 * 245.0 / 850, 1e-9);
}

TEST(CameraView, WhatItSeesIsPlacedBackWhereItStands) {
  for (std::uint64_t seed = 1; seed <= 500; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const forms::CameraPose pose{{1330 + random.uniform(-50, 50), random.uniform(-50, 50), 200},
                                 random.uniform(-20, 20),
                                 random.uniform(-25, 15)};
    const CameraView view(pose, {});
    const Eigen::Vector3d point(random.uniform(300, 600), random.uniform(-300, 300), random.uniform(0, 400));
    const Sight sight = view.sight(point);
    EXPECT_LT((placed(view, sight) - point).norm(), 1e-6);
  }
}

TEST(CameraView, AHeadThatTurnsItTurnsTheImageAndNotWhereThingsAre) {
  for (std::uint64_t seed = 1; seed <= 500; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const forms::CameraPose mount{{1330, 20, 200}, random.uniform(-10, 10), random.uniform(-10, 5)};
    const HeadTurn head{random.uniform(-12, 12), random.uniform(-10, 10)};
    const forms::CameraPose turned{mount.at_mm, mount.pan_deg + head.pan_deg, mount.tilt_deg + head.tilt_deg};
    const CameraView view(mount, {}, head);
    const Eigen::Vector3d point(random.uniform(300, 600), random.uniform(-300, 300), random.uniform(0, 400));
    const Sight sight = view.sight(point);
    const Sight as_mounted = CameraView(turned, {}).sight(point);
    EXPECT_NEAR(sight.x_px, as_mounted.x_px, 1e-9);
    EXPECT_NEAR(sight.y_px, as_mounted.y_px, 1e-9);
    EXPECT_LT((placed(view, sight) - point).norm(), 1e-6);
    EXPECT_LT((view.away() - CameraView(mount, {}).away()).norm(), 1e-12);
  }
}

TEST(CameraView, RefusesAModelThatIsNone) {
  EXPECT_FALSE(camera_model_from_fact(list("camera-model"_sym, "vision"_sym, 320, 240, 0.0, 160.0, 120.0, 90.0)));
  EXPECT_FALSE(camera_model_from_fact(list("camera-model"_sym, "vision"_sym, 320)));
  EXPECT_TRUE(camera_model_from_fact(list("camera-model"_sym, "vision"_sym, 320, 240, 431.0, 159.5, 119.5, 90.0)));
}

TEST(CameraView, ShowsWhatBothImagesShowWhole) {
  const CameraView view({}, {});
  EXPECT_TRUE(view.shows({480, 0, 30}, 22));
  EXPECT_TRUE(view.shows({480, -245, 30}, 22));
  EXPECT_FALSE(view.shows({480, -275, 30}, 22)) << "the right image does not show it";
  EXPECT_FALSE(view.shows({480, 275, 30}, 22)) << "the left image does not show it";
  EXPECT_FALSE(view.shows({605, -245, 30}, 22)) << "nearer the camera less is shown";
  EXPECT_FALSE(view.shows({480, 0, 430}, 22));
}

TEST(ServoErrors, TurningAndExtendingByThemArrives) {
  const CameraView view({}, {});
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const auto somewhere = [&] {
      return Eigen::Vector3d(random.uniform(380, 520), random.uniform(-230, 230), random.uniform(30, 300));
    };
    const Eigen::Vector3d foot(0, random.uniform(-300, 300), 0);
    const Aim aim{somewhere(), somewhere(), 100, foot};
    const ServoErrors errors = servo_errors(aim, view, 30, 300);
    const Eigen::Vector3d axis = aim.followed_mm + 30 * view.away() - foot;
    const double bearing = std::atan2(axis.y(), axis.x()) + errors.bearing_deg * M_PI / 180;
    const double radius = std::hypot(axis.x(), axis.y()) + errors.along_mm;
    const Eigen::Vector3d wanted = aim.wanted_mm + 30 * view.away() - foot;
    EXPECT_NEAR(radius * std::cos(bearing), wanted.x(), 1e-6);
    EXPECT_NEAR(radius * std::sin(bearing), wanted.y(), 1e-6);
    EXPECT_NEAR(aim.followed_mm.z() - errors.down_mm, aim.wanted_mm.z(), 1e-9);
  }
}

TEST(FreeSpot, TakesTheNearestThatIsComfortable) {
  const std::optional<Eigen::Vector2d> spot = free_spot({}, {{450, 0}}, 20);
  ASSERT_TRUE(spot);
  EXPECT_NEAR(spot->y(), 100, 1e-9);
}

TEST(FreeSpot, IsBehindTheRowWhereThatIsFullAndHiddenByNothing) {
  const std::optional<Eigen::Vector2d> spot = free_spot({}, {{450, -150}, {450, 0}, {450, 150}}, 150);
  ASSERT_TRUE(spot);
  EXPECT_NEAR(spot->x(), 360, 1e-9);
  EXPECT_NEAR(std::abs(spot->y()), 80, 1e-9) << "between two of those before it";
}

// The fingers have room beside what stands in the same row, and the camera sees past what stands in another.
bool usable(const TableArea& area, const Eigen::Vector2d& spot, const std::vector<Eigen::Vector2d>& occupied) {
  return std::ranges::all_of(occupied, [&](const Eigen::Vector2d& other) {
    const bool same_row = std::abs(other.x() - spot.x()) < area.depth_mm;
    return std::abs(other.y() - spot.y()) >= (same_row ? area.least_mm : area.unhidden_mm) - 1e-6;
  });
}

bool in_reach(const TableArea& area, const Eigen::Vector2d& spot) {
  return spot.norm() >= area.reach_low_mm && spot.norm() <= area.reach_high_mm;
}

TEST(FreeSpot, LeavesTheFingersRoomAndTheCameraAViewAndIsFoundWhereThereIsOne) {
  const TableArea area;
  for (std::uint64_t seed = 1; seed <= 500; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    std::vector<Eigen::Vector2d> occupied;
    for (std::uint64_t n = random.below(9); n > 0; --n) {
      occupied.emplace_back(random.uniform(300, 600), random.uniform(-220, 220));
    }
    const std::optional<Eigen::Vector2d> spot = free_spot(area, occupied, random.uniform(-200, 200));
    bool possible = false;
    for (double x = area.x_mm - area.aside_mm; x <= area.x_mm + area.aside_mm; x += area.grid_mm) {
      for (double y = area.y_low_mm; y <= area.y_high_mm; y += area.grid_mm) {
        possible = possible || (in_reach(area, {x, y}) && usable(area, {x, y}, occupied));
      }
    }
    EXPECT_EQ(spot.has_value(), possible);
    EXPECT_TRUE(!spot || (in_reach(area, *spot) && usable(area, *spot, occupied)));
  }
}

TEST(FreeSpot, IsFoundBetweenRowsWhereNoRowHasOne) {
  const TableArea area;
  const std::vector<Eigen::Vector2d> occupied{{428, -146}, {428, 147}, {473, 3}};
  const std::optional<Eigen::Vector2d> spot = free_spot(area, occupied, -150);
  ASSERT_TRUE(spot);
  EXPECT_TRUE(usable(area, *spot, occupied)) << *spot;
}

TEST(SightLines, RunFromEachEyePastWhatStandsAsideOfThem) {
  const SightLines lines{.eyes_mm = {{1330, -45, 200}, {1330, 45, 200}}};
  const Eigen::Vector3d far_aside(289, -239, 30);
  EXPECT_TRUE(lines.covers({450, -170, 30}, far_aside)) << "nearer the middle by more than a cube";
  EXPECT_FALSE(lines.covers({450, -100, 30}, far_aside));
  EXPECT_FALSE(lines.covers({450, -280, 30}, far_aside));
  EXPECT_FALSE(lines.covers(far_aside, {450, -170, 30})) << "it stands behind";
  EXPECT_TRUE(lines.cross(far_aside, {450, -170, 30}));
  EXPECT_FALSE(lines.covers({450, -170, 30}, {289, -239, 150})) << "the eyes look over it";
  EXPECT_TRUE(lines.covers({450, 0, 30}, {330, 0, 30}));
  EXPECT_FALSE(lines.covers({450, 0, 30}, {230, 0, 90})) << "the eyes look over it";
  const SightLines from_above{.eyes_mm = {{1300, -45, 520}, {1300, 45, 520}}};
  EXPECT_FALSE(from_above.covers({450, 0, 30}, {270, 0, 30})) << "the eyes look down behind it";
  EXPECT_TRUE(from_above.covers({450, 0, 90}, {270, 0, 30}));
  EXPECT_TRUE(lines.covers({450, 0, 30}, {270, 0, 30}));
  EXPECT_FALSE(SightLines().covers({450, 0, 30}, {300, 0, 30})) << "without eyes nothing is covered";
}

// A tower's two cubes between the fingers are no reason to keep holding them.
TEST(FreeSpot, IsNotTakenByWhatHangsInTheGripper) {
  const std::vector<Eigen::Vector3d> centres{{450, 0, 30}, {440, -158, 300}, {430, -150, 270}};
  const Eigen::Vector3d grip(440, -158, 300);
  EXPECT_EQ(standing(centres, grip, 60), (std::vector<Eigen::Vector3d>{{450, 0, 30}}));
  EXPECT_EQ(standing(centres, std::nullopt, 60).size(), 3u);
}

TEST(FreeSpot, IsWhereItsMarkIsShown) {
  const auto shown = [](const Eigen::Vector2d& spot) { return spot.y() > 0; };
  const std::optional<Eigen::Vector2d> spot = free_spot({}, {{450, 150}}, -150, shown);
  ASSERT_TRUE(spot);
  EXPECT_GT(spot->y(), 0);
  EXPECT_FALSE(free_spot({}, {}, 0, [](const Eigen::Vector2d&) { return false; }));
}

TEST(Opening, IsWideAloneAndNarrowBetweenNeighbours) {
  const Eigen::Vector3d centre(450, 0, 30);
  EXPECT_EQ(opening_between(centre, {}, 60, 8, 76, 96), 96);
  EXPECT_EQ(opening_between(centre, {{450, 80, 30}}, 60, 8, 76, 96), 76);
  EXPECT_NEAR(opening_between(centre, {{450, 88, 30}}, 60, 8, 76, 96), 92, 1e-9);
  // Behind, or under the gripper, nothing is in the way.
  EXPECT_EQ(opening_between(centre, {{390, 70, 30}}, 60, 8, 76, 96), 96);
  EXPECT_EQ(opening_between({450, 0, 90}, {{450, 70, 30}}, 60, 8, 76, 96), 96);
}

TEST(ElbowRoom, IsThereWithoutNeighbours) { EXPECT_FALSE(is_crowded({}, {450, 0, 30}, {{450, 100, 30}})); }

// The neighbour stands aslant behind the cube, where a finger comes to stand once the gripper is turned.
TEST(ElbowRoom, IsAskedForWhereTheTurnedFingersGo) {
  const Eigen::Vector3d centre(495, -89, 30);
  const std::vector<Eigen::Vector3d> others{{449, -147, 30}};
  const auto opening = [&](double fingers_deg) {
    return opening_between(centre, seen_from_fingers(fingers_deg, centre, others), 60, 8, 76, 96);
  };
  ElbowRoom room;
  EXPECT_FALSE(is_crowded(room, centre, others));
  EXPECT_EQ(opening(0), 96);
  room.fingers_deg = -10;
  EXPECT_TRUE(is_crowded(room, centre, others));
  EXPECT_EQ(opening(-10), 76);
}

TEST(ElbowRoom, IsMadeByPushingOutOfTheRow) {
  const Eigen::Vector3d centre(450, 0, 30);
  const std::vector<Eigen::Vector3d> others{{455, 60, 30}};
  ASSERT_TRUE(is_crowded({}, centre, others));
  const std::optional<Push> push = push_for_room({}, centre, others);
  ASSERT_TRUE(push);
  EXPECT_EQ(push->from_mm.y(), push->to_mm.y());
}

TEST(ElbowRoom, EveryPushEndsTheCrowdingAndTouchesNothingElse) {
  const ElbowRoom room;
  int pushes = 0;
  for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const Eigen::Vector3d centre(random.uniform(420, 480), random.uniform(-200, 200), 30);
    std::vector<Eigen::Vector3d> others;
    for (std::uint64_t n = 1 + random.below(3); n > 0; --n) {
      const Eigen::Vector3d other(random.uniform(380, 520), centre.y() + random.uniform(-150, 150), 30);
      const Eigen::Vector3d apart = (other - centre).cwiseAbs();
      if (apart.x() > 62 || apart.y() > 61) others.push_back(other);
    }
    const std::optional<Push> push = push_for_room(room, centre, others);
    if (!push) continue;
    ++pushes;
    // The fingers' front meets the face, then the cube goes with it.
    const double sign = push->to_mm.x() > push->from_mm.x() ? 1 : -1;
    const double reach = push->face_deg == 0 ? room.finger_half_mm : room.pusher_mm / 2 + room.finger_mm;
    const double contact = room.cube_mm / 2 + reach;
    const Eigen::Vector3d after(push->to_mm.x() + sign * contact, centre.y(), 30);
    EXPECT_GT(sign * (centre.x() - push->from_mm.x()), contact);
    EXPECT_FALSE(is_crowded(room, after, others));
    for (const Eigen::Vector3d& other : others) {
      const Eigen::Vector3d apart = (other - after).cwiseAbs();
      EXPECT_TRUE(apart.x() > room.cube_mm - 1 || apart.y() > room.cube_mm - 3);
    }
  }
  EXPECT_GT(pushes, 100);
}

// Cubes that stand so far apart leave room for the fingers; the palm is wider, and passes over a low neighbour alone.
TEST(ElbowRoom, IsAskedForWhereThePalmWouldTouchAHighPile) {
  const Eigen::Vector3d centre(450, 0, 30);
  EXPECT_FALSE(is_crowded({}, centre, {{450, 90, 30}}));
  EXPECT_TRUE(is_crowded({}, centre, {{450, 90, 30}, {450, 90, 90}, {450, 90, 150}}));
  EXPECT_FALSE(is_crowded({}, centre, {{450, 100, 30}, {450, 100, 90}, {450, 100, 150}}));
  EXPECT_FALSE(is_crowded({}, centre, {{510, 90, 30}, {510, 90, 90}, {510, 90, 150}})) << "the palm passes behind it";
  EXPECT_FALSE(is_crowded({}, {450, 0, 150}, {{450, 90, 30}, {450, 90, 90}, {450, 90, 150}})) << "it is as high";
}

TEST(ElbowRoom, APushBesideAHighPileIsMadeWithTheGripperTurned) {
  const Eigen::Vector3d centre(450, 0, 30);
  const std::optional<Push> beside_low = push_for_room({}, centre, {{450, 68, 30}});
  ASSERT_TRUE(beside_low);
  EXPECT_EQ(beside_low->face_deg, 0);
  const std::vector<Eigen::Vector3d> high{{450, 68, 30}, {450, 68, 90}, {450, 68, 150}};
  const std::optional<Push> beside_high = push_for_room({}, centre, high);
  ASSERT_TRUE(beside_high);
  EXPECT_EQ(beside_high->face_deg, 90);
  EXPECT_FALSE(push_for_room({}, centre, {{450, 45, 30}, {450, 45, 90}, {450, 45, 150}})) << "not even the turned palm";
}

TEST(ElbowRoom, NoPushTakesACubeOutOfTheImages) {
  ElbowRoom room;
  const Eigen::Vector3d centre(450, 100, 30);
  room.shown = [](const Eigen::Vector3d& at) { return at.x() <= 450; };
  const std::optional<Push> push = push_for_room(room, centre, {{450, 165, 30}});
  ASSERT_TRUE(push);
  EXPECT_LT(push->to_mm.x(), push->from_mm.x());
  room.shown = [](const Eigen::Vector3d&) { return false; };
  EXPECT_FALSE(push_for_room(room, centre, {{450, 165, 30}}));
}

TEST(ElbowRoom, APushOverGoesTowardsTheCameraUnlessItLeadsOutOfTheImages) {
  ElbowRoom room;
  const Eigen::Vector3d centre(450, -300, 45);
  const Push towards = push_over_from(room, centre);
  EXPECT_LT(towards.from_mm.x(), centre.x());
  EXPECT_EQ(towards.to_mm.x(), centre.x() + room.cube_mm / 2);
  room.shown = [](const Eigen::Vector3d& at) { return at.x() <= 460; };
  const Push away = push_over_from(room, centre);
  EXPECT_GT(away.from_mm.x(), centre.x());
  EXPECT_EQ(away.to_mm.x(), centre.x() - room.cube_mm / 2);
}

TEST(ElbowRoom, APushIntoViewGoesJustAsFarAsTheImagesShowAndSparesOthers) {
  ElbowRoom room;
  const Eigen::Vector3d centre(535, -10, 30);
  EXPECT_FALSE(push_into_view(room, centre, {})) << "all of it shows";
  room.shown = [](const Eigen::Vector3d& at) { return at.x() <= 505; };
  const std::optional<Push> push = push_into_view(room, centre, {{442, 45, 30}});
  ASSERT_TRUE(push);
  EXPECT_GT(push->from_mm.x(), centre.x() + room.cube_mm / 2);
  const double length = push->from_mm.x() - push->to_mm.x() - 2 * room.margin_mm;
  EXPECT_GE(length, 30);
  EXPECT_LE(length, 34);
  EXPECT_FALSE(push_into_view(room, centre, {{450, -10, 30}})) << "another one stands where it would go";
  EXPECT_FALSE(push_into_view(room, {580, -10, 30}, {})) << "the arm does not come behind it";
}

TEST(ElbowRoom, APushLeavesAllMarksInSightOfBothEyesWhereItCan) {
  ElbowRoom room;
  room.eyes_mm = {{1330, -45, 200}, {1330, 45, 200}};
  const auto towards_the_camera = [&room](double y_mm, double neighbour_y_mm) {
    const std::optional<Push> push = push_for_room(room, {450, y_mm, 30}, {{450, neighbour_y_mm, 30}});
    EXPECT_TRUE(push);
    return push && push->to_mm.x() > push->from_mm.x();
  };
  EXPECT_TRUE(towards_the_camera(100, 35));
  EXPECT_FALSE(towards_the_camera(100, 165)) << "it would stand before the neighbour's mark";
  EXPECT_TRUE(towards_the_camera(-165, -100));
  EXPECT_FALSE(towards_the_camera(-165, -230));
  room.eyes_mm.clear();
  EXPECT_TRUE(towards_the_camera(100, 165)) << "the shortest, where nobody looks";
}

}  // namespace
}  // namespace pizarra::coordinator
