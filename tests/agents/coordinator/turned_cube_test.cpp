// A cube whose mark looks aside: what is grasped is its middle, and its mark faces the camera afterwards.

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "agents/coordinator/perceive/scene.hpp"
#include "tests/agents/coordinator/fake_cell.hpp"
#include "tests/source_dir.hpp"

namespace pizarra::coordinator {
namespace {

class TurnedCube : public testing::TestWithParam<double> {
 protected:
  void SetUp() override { cell.faces_deg["circle"] = GetParam(); }

  FakeCell cell{"blocks.scm", {{"circle", {450, -100, 30}}, {"square", {450, 100, 30}}}};
};

TEST_P(TurnedCube, IsGraspedByItsMiddleAtTheFirstTry) {
  cell.start_coordinator();
  cell.request("coordinator", "(goal (holding circle))");
  ASSERT_TRUE(cell.run_until("(goal-state 1 reached ?)", 60s));
  EXPECT_EQ(cell.times_told("(operation ? (PICK-UP circle) failed)"), 0);
  EXPECT_LT((cell.cubes["circle"] - cell.grip).head<2>().norm(), 4);
}

TEST_P(TurnedCube, FacesTheCameraOnceItIsHeld) {
  cell.start_coordinator();
  cell.request("coordinator", "(goal (holding circle))");
  ASSERT_TRUE(cell.run_until("(goal-state 1 reached ?)", 60s));
  EXPECT_LT(std::abs(cell.faces_deg["circle"]), 15);
}

INSTANTIATE_TEST_SUITE_P(ByDegrees, TurnedCube, testing::Values(-52.0, -46.0, -30.0, 20.0, 44.0, 50.0));

TEST(Scene, PlacesWhatIsHeldBeforeTheTurnedFingersWhereTheGrippersMarkIsNotSeen) {
  const CoordinatorOptions options;
  const TaskDomain domain = TaskDomain::read(source_dir() + "/domains/blocks.scm").value();
  Scene scene(options, domain);
  scene.take_camera(CameraModel());
  scene.take_pose(tool_pose({450, 100, 200}, 180, 0, 40));
  const double front_mm = domain.cube_mm() / 2;
  const double yaw = 40 * std::numbers::pi / 180;
  const Eigen::Vector3d front(450 + front_mm * std::cos(yaw), 100 + front_mm * std::sin(yaw), 200);
  EXPECT_LT((*scene.grip_mm() - front).norm(), 0.1);
}

TEST(Scene, DoesNotExcuseWhatWasSeenBetweenTheFingersAsHiddenByThem) {
  const CoordinatorOptions options;
  const TaskDomain domain = TaskDomain::read(source_dir() + "/domains/blocks.scm").value();
  Scene scene(options, domain);
  scene.take_camera(CameraModel());
  scene.take_pose(tool_pose({450, 100, 200}, 180, 0, 0));
  scene.take_opening(domain.cube_mm());
  const Eigen::Vector3d grip = *scene.grip_mm();
  const forms::PerceivedLook shown{{{"circle", {grip.x(), grip.y(), grip.z()}, {}}}, {}, std::vector<Datum>()};
  const forms::PerceivedLook nothing{{}, {}, std::vector<Datum>()};
  scene.take_look(1, shown, false);
  scene.take_look(2, nothing, false);
  const std::vector<Datum> remembered = scene.situation().remembered;
  ASSERT_EQ(remembered.size(), 1u);
  EXPECT_EQ(remembered[0][3].integer(), 0) << "a look may excuse it";
}

}  // namespace
}  // namespace pizarra::coordinator
