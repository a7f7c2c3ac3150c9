#include "agents/coordinator/geometry/border_sweeps.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace pizarra::coordinator {
namespace {

constexpr double border_mm = 230;
constexpr double row_x_mm = 450;

ElbowRoom room_with_a_border() {
  ElbowRoom room;
  room.shown = [](const Eigen::Vector3d& centre) { return std::abs(centre.y()) <= border_mm; };
  return room;
}

ElbowRoom room_with_a_lower_border() {
  ElbowRoom room;
  room.shown = [](const Eigen::Vector3d& centre) { return centre.x() <= 580; };
  return room;
}

// Where a cube comes to lie that the fingers meet on their way.
double swept_to_y_mm(const Push& sweep, const ElbowRoom& room) {
  const double towards = sweep.to_mm.y() > sweep.from_mm.y() ? 1 : -1;
  return sweep.to_mm.y() + towards * (room.finger_half_mm + room.cube_mm / 2);
}

TEST(BorderSweeps, PushACubeFromBesideTheImagesToWhereItShows) {
  const ElbowRoom room = room_with_a_border();
  const std::vector<Push> sweeps = border_sweeps(room, row_x_mm, {{450, 200, 90}, 270}, {});
  ASSERT_FALSE(sweeps.empty());
  for (const Push& sweep : sweeps) {
    EXPECT_GT(std::abs(sweep.from_mm.y()), border_mm + 2 * room.cube_mm);
    EXPECT_TRUE(room.shown({sweep.to_mm.x(), swept_to_y_mm(sweep, room), 30}));
    EXPECT_EQ(sweep.from_mm.x(), sweep.to_mm.x());
    EXPECT_EQ(sweep.face_deg, 90);
  }
}

TEST(BorderSweeps, LeaveNoGapBetweenOneAnother) {
  const ElbowRoom room = room_with_a_border();
  const std::vector<Push> sweeps = border_sweeps(room, row_x_mm, {{450, 200, 90}, 270}, {});
  const double half_mm = room.pusher_mm / 2 + room.finger_mm + room.cube_mm / 2;
  for (double x_mm = 350; x_mm <= 550; x_mm += 10) {
    const auto meets = [&](const Push& sweep) {
      return sweep.from_mm.y() > 0 && std::abs(sweep.from_mm.x() - x_mm) < half_mm;
    };
    EXPECT_TRUE(std::ranges::any_of(sweeps, meets)) << x_mm;
  }
}

TEST(BorderSweeps, BeginWhereTheCubeWasLost) {
  const std::vector<Push> right = border_sweeps(room_with_a_border(), row_x_mm, {{380, -210, 30}, 210}, {});
  ASSERT_FALSE(right.empty());
  EXPECT_LT(right.front().from_mm.y(), 0);
  EXPECT_EQ(right.front().from_mm.x(), 360);
}

TEST(BorderSweeps, AreMadeOnlyWhereTheCubeMayHaveComeTo) {
  EXPECT_TRUE(border_sweeps(room_with_a_border(), row_x_mm, {{450, 0, 30}, 210}, {}).empty());
  for (const Push& sweep : border_sweeps(room_with_a_border(), row_x_mm, {{450, 100, 30}, 210}, {})) {
    EXPECT_GT(sweep.from_mm.y(), 0);
  }
}

TEST(BorderSweeps, MeetNoCubeThatStands) {
  const std::vector<Push> sweeps =
      border_sweeps(room_with_a_border(), row_x_mm, {{450, 200, 90}, 270}, {{450, 190, 30}});
  ASSERT_FALSE(sweeps.empty());
  for (const Push& sweep : sweeps) EXPECT_TRUE(sweep.from_mm.y() < 0 || std::abs(sweep.from_mm.x() - 450) > 56);
}

TEST(BorderSweeps, BeforeTheImagesTheFingersGoDownAroundTheCubeFirstWhereItWasLost) {
  const ElbowRoom room = room_with_a_lower_border();
  const std::vector<Push> grips = border_sweeps(room, row_x_mm, {{515, -25, 150}, 330}, {});
  ASSERT_GE(grips.size(), 3U);
  EXPECT_EQ(grips.front().from_mm.y(), -25);
  for (const Push& grip : grips) {
    EXPECT_TRUE(grip.lifts);
    EXPECT_EQ(grip.face_deg, 90);
    EXPECT_LE(grip.from_mm.norm(), room.grip_high_mm + 0.01);
    // The fingers stand before and behind a cube that lies just beyond the border.
    const double inside_mm = room.wide_mm / 2 - room.cube_mm / 2;
    EXPECT_LT(grip.from_mm.x() - inside_mm, 600);
    EXPECT_GT(grip.from_mm.x() + inside_mm, 610);
  }
}

TEST(BorderSweeps, BeforeTheImagesGoDownOnNoCubeThatStandsAndNowhereWhereAllIsShown) {
  const ElbowRoom room = room_with_a_lower_border();
  const LostCube lost{{515, -25, 150}, 330};
  for (const Push& grip : border_sweeps(room, row_x_mm, lost, {{540, -30, 30}})) EXPECT_NE(grip.from_mm.y(), -25);
  EXPECT_EQ(border_sweeps(room, row_x_mm, lost, {{480, -30, 30}}).size(),
            border_sweeps(room, row_x_mm, lost, {}).size());
  ElbowRoom further = room;
  further.shown = [](const Eigen::Vector3d& centre) { return centre.x() <= 620; };
  EXPECT_TRUE(border_sweeps(further, row_x_mm, lost, {}).empty());
}

// A camera that was knocked down shows less of the table before it, and not even all of the row.
TEST(BorderSweeps, PullACubeFromBeforeTheImagesWhereTheArmComesBeyondIt) {
  ElbowRoom room;
  room.shown = [](const Eigen::Vector3d& centre) { return centre.x() <= 445; };
  const std::vector<Push> sweeps = border_sweeps(room, row_x_mm, {{465, 102, 30}, 210}, {{411, 230, 30}});
  ASSERT_FALSE(sweeps.empty());
  const Push& pull = sweeps.front();
  EXPECT_FALSE(pull.lifts);
  EXPECT_EQ(pull.from_mm.y(), 102);
  EXPECT_EQ(pull.to_mm.y(), 102);
  EXPECT_LE(pull.from_mm.norm(), room.reach_high_mm + 0.01);
  EXPECT_GT(pull.from_mm.x() - room.finger_half_mm - room.cube_mm / 2, 500);
  EXPECT_TRUE(room.shown({pull.to_mm.x() - room.finger_half_mm - room.cube_mm / 2, 102, 30}));
}

// A cube that fell beside another may have rolled off along the border.
TEST(BorderSweeps, PullOverAllOfTheLowerBorderThatTheCubeMayHaveComeTo) {
  ElbowRoom room;
  room.shown = [](const Eigen::Vector3d& centre) { return centre.x() <= 445; };
  const double half_mm = room.pusher_mm / 2 + room.finger_mm + room.cube_mm / 2;
  const std::vector<Push> near = border_sweeps(room, row_x_mm, {{440, 0, 30}, 150}, {});
  const std::vector<Push> far = border_sweeps(room, row_x_mm, {{440, 0, 90}, 330}, {});
  const auto pulls_at = [&](const std::vector<Push>& sweeps, double y_mm) {
    return std::ranges::any_of(
        sweeps, [&](const Push& sweep) { return !sweep.lifts && std::abs(sweep.from_mm.y() - y_mm) < half_mm; });
  };
  for (double y_mm = -270; y_mm <= 270; y_mm += 30) EXPECT_TRUE(pulls_at(far, y_mm)) << y_mm;
  EXPECT_FALSE(pulls_at(near, 250));
}

TEST(BorderSweeps, PullNoCubeThatStands) {
  ElbowRoom room;
  room.shown = [](const Eigen::Vector3d& centre) { return centre.x() <= 445; };
  const Eigen::Vector3d standing(411, 130, 30);
  for (const Push& sweep : border_sweeps(room, row_x_mm, {{465, 102, 30}, 210}, {standing})) {
    EXPECT_TRUE(sweep.lifts || std::abs(sweep.from_mm.y() - standing.y()) > 56);
  }
}

TEST(BorderSweeps, AreNoneWhereNobodyKnowsWhatIsShownOrAllOfItIs) {
  EXPECT_TRUE(border_sweeps({}, row_x_mm, {{450, 200, 90}, 270}, {}).empty());
  ElbowRoom all;
  all.shown = [](const Eigen::Vector3d&) { return true; };
  EXPECT_TRUE(border_sweeps(all, row_x_mm, {{450, 200, 90}, 270}, {}).empty());
}

}  // namespace
}  // namespace pizarra::coordinator
