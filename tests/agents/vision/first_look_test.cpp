// Marks that are seen for the first time, whole or hidden in part. A mark that is told surely is where it is told,
// however it lay when it was learned. Most whole marks are told surely.

#include "tests/agents/vision/first_look.hpp"

#include <gtest/gtest.h>
#include <ostream>
#include <string_view>

namespace pizarra::vision {
namespace {

struct Learned {
  const char* name;
  const char* mark;
  Pose pose;
  double least_sure = 0.95;  // of whole ones

  friend void PrintTo(const Learned& learned, std::ostream* out) { *out << learned.name; }
};

constexpr Learned all_learned[] = {{"BarLying", "bar", {}},
                                   {"BarUpright", "bar", {.roll_deg = 90}},
                                   {"BarRolled", "bar", {.roll_deg = 40}},
                                   {"BarYawed", "bar", {.yaw_deg = 25}},
                                   // Its face is hardly longer.
                                   {"ThinBarLying", "thin-bar", {}, 0.9},
                                   {"ThinBarUpright", "thin-bar", {.roll_deg = 90}, 0.9},
                                   // How far what is so narrow is turned away a pair knows badly.
                                   {"ThinBarYawedUpright", "thin-bar", {.roll_deg = 90, .yaw_deg = -25}, 0.4},
                                   {"Square", "square", {}},
                                   {"SquareYawed", "square", {.yaw_deg = 25}},
                                   {"SquareTilted", "square", {.pitch_deg = 20}},
                                   {"Circle", "circle", {}},
                                   {"Cross", "cross", {}},
                                   {"Triangle", "triangle", {}},
                                   {"EndEffector", "end-effector", {}}};

class FirstLook : public testing::TestWithParam<Learned> {
 protected:
  static constexpr int tries = 60;
  void look(FirstLooks::Cover cover) {
    for (int seed = 1; seed <= tries; ++seed) {
      looks.look(GetParam().mark, cover, static_cast<std::uint64_t>(seed));
    }
  }
  static void expect_true(const ToldOfMeeting& told) {
    EXPECT_LT(told.most_off_px, 1.5);
    EXPECT_LE(told.wrong, 1) << "of " << told.sure << " sure ones of " << told.positions;
  }
  FirstLooks looks{learned_as(GetParam().mark, GetParam().pose)};
};

TEST_P(FirstLook, AtWhatIsHiddenIsSureOnlyOfWhereTheMarkIs) {
  // A cover along a side of a triangle leaves a triangle, and one camera does not know how far away that is.
  const bool by_one_as_well = std::string_view(GetParam().mark) != "triangle";
  for (const FirstLooks::Cover cover : {FirstLooks::Cover::as_far, FirstLooks::Cover::nearer}) {
    SCOPED_TRACE(cover == FirstLooks::Cover::as_far ? "by what is as far away" : "by what is nearer");
    looks.by_pair = looks.by_one = {};
    look(cover);
    expect_true(looks.by_pair);
    if (by_one_as_well) expect_true(looks.by_one);
  }
}

TEST_P(FirstLook, AtAWholeMarkIsSure) {
  look(FirstLooks::Cover::none);
  EXPECT_EQ(looks.by_pair.positions, tries);
  EXPECT_EQ(looks.by_one.positions, tries);
  EXPECT_GE(looks.by_pair.sure, GetParam().least_sure * tries);
  EXPECT_EQ(looks.by_pair.wrong + looks.by_one.wrong, 0);
}

// One camera does not know of a triangle that looks smaller than it was learned whether it is whole and farther away,
// or nearer and covered along a side. Of others their form says it.
class FirstLookAtATriangle : public testing::TestWithParam<const char*> {
 protected:
  void look(FirstLooks::Cover cover) {
    for (std::uint64_t seed = 101; seed <= 160; ++seed) looks.look(GetParam(), cover, seed);
  }
  FirstLooks looks{learned_as(GetParam(), {})};
};

TEST_P(FirstLookAtATriangle, ByOneCameraThatIsFartherAwayThanItWasLearnedIsTrueAndNotSure) {
  looks.nearest_mm = 1.05 * learned_mm;
  look(FirstLooks::Cover::none);
  EXPECT_EQ(looks.by_one.positions, 60);
  EXPECT_LT(looks.by_one.most_told_off_px, 0.5);
  EXPECT_EQ(looks.by_one.sure, 0);
  EXPECT_GE(looks.by_pair.sure, 57);
  looks.nearest_mm = learned_mm;
  look(FirstLooks::Cover::as_far);
  look(FirstLooks::Cover::nearer);
  EXPECT_EQ(looks.by_one.wrong, 0) << "of " << looks.by_one.sure;
}

TEST_P(FirstLookAtATriangle, ByOneCameraThatFacesItAsNearAsItWasLearnedIsSure) {
  looks.farthest_mm = 0.98 * learned_mm;
  looks.faces = true;
  look(FirstLooks::Cover::none);
  EXPECT_EQ(looks.by_one.positions, 60);
  EXPECT_GE(looks.by_one.sure, 57);
  EXPECT_EQ(looks.by_one.wrong, 0);
}

INSTANTIATE_TEST_SUITE_P(Marks, FirstLookAtATriangle, testing::Values("triangle", "end-effector"),
                         [](const auto& one) { return one.param[0] == 't' ? "Triangle" : "EndEffector"; });

INSTANTIATE_TEST_SUITE_P(Marks, FirstLook, testing::ValuesIn(all_learned),
                         [](const auto& one) { return std::string(one.param.name); });

}  // namespace
}  // namespace pizarra::vision
