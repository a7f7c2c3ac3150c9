#include "agents/coordinator/geometry/occlusion.hpp"

#include <gtest/gtest.h>

#include "agents/coordinator/geometry/sightings.hpp"
#include "lisp/reader.hpp"

namespace pizarra::coordinator {
namespace {

const CameraView view{forms::CameraPose{}, CameraModel{}};
const GripperOutline outline;
const Eigen::Vector3d low_grip(480, 0, 30);

TEST(Occlusion, TheGripperHidesWhatStandsBehindItAndAboveItsFingertips) {
  EXPECT_TRUE(hidden_by_gripper(view, outline, low_grip, {400, 0, 30}));
  EXPECT_TRUE(hidden_by_gripper(view, outline, low_grip, {400, 40, 150}));
  EXPECT_TRUE(hidden_by_gripper(view, outline, low_grip, {480, 60, 60})) << "beside it, under the palm";
}

TEST(Occlusion, ItHidesNothingBesideBelowOrBeforeIt) {
  EXPECT_FALSE(hidden_by_gripper(view, outline, low_grip, {400, 150, 30}));
  EXPECT_FALSE(hidden_by_gripper(view, outline, low_grip, {560, 0, 30}));
  const Eigen::Vector3d high_grip(480, 0, 300);
  EXPECT_FALSE(hidden_by_gripper(view, outline, high_grip, {450, 0, 30}));
}

Datum track(std::string_view text) { return read_one(text).value(); }

TEST(Sightings, AnExcusedObjectStaysAsYoungAsItWasButNotForEver) {
  Sightings sightings;
  sightings.look(1, track("(track (\"circle\" 150.0 200.0 870.0))"), view);
  const Datum unseen = track("(track (\"circle\" fail))");
  for (int i = 0; i < Sightings::most_excused; ++i) {
    sightings.look(2 + i, unseen, view);
    sightings.excuse("circle");
    ASSERT_TRUE(sightings.recent("circle", 2)) << i;
  }
  for (int i = 0; i < 10; ++i) {
    sightings.look(1000 + i, unseen, view);
    sightings.excuse("circle");
  }
  EXPECT_FALSE(sightings.recent("circle", 10));
}

}  // namespace
}  // namespace pizarra::coordinator
