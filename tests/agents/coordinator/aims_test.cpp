// Where the gripper, and what it holds, is taken to be while the eyes do not show it.

#include <gtest/gtest.h>

#include "agents/coordinator/act/aim.hpp"
#include "tests/source_dir.hpp"

namespace pizarra::coordinator {
namespace {

forms::PerceivedLook look_at(std::initializer_list<std::pair<std::string, Eigen::Vector3d>> objects) {
  forms::PerceivedLook look{{}, {}, std::vector<Datum>()};
  for (const auto& [name, at] : objects) look.seen.push_back({name, {at.x(), at.y(), at.z()}, {}});
  return look;
}

// Else the arm goes to and fro where the images end: there one place shows what is held, and the next does not.
TEST(Aims, FollowWhatIsHeldWhereItWasSeenInTheFingersOnceItIsHidden) {
  const CoordinatorOptions options;
  const TaskDomain domain = TaskDomain::read(source_dir() + "/domains/blocks.scm").value();
  Scene scene(options, domain);
  scene.take_camera(CameraModel());
  scene.take_pose(tool_pose({450, 100, 200}, 180, 0, 0));
  scene.take_opening(domain.cube_mm());
  const Eigen::Vector3d seen = *scene.grip_mm() + Eigen::Vector3d(4, 12, 0);
  const Eigen::Vector3d triangle(480, 120, 30);
  const Datum goal = list("on-top"_sym, "circle"_sym, "triangle"_sym);
  Aims aims(options, domain, scene);
  scene.take_look(1, look_at({{"circle", seen}, {"triangle", triangle}}), false);
  EXPECT_LT((aims.at(goal)->followed_mm - seen).norm(), 1e-9);
  const Eigen::Vector3d step(0, 6, 0);
  scene.take_pose(tool_pose({450, 106, 200}, 180, 0, 0));
  scene.take_look(2, look_at({{"triangle", triangle}}), false);
  EXPECT_LT((aims.at(goal)->followed_mm - seen - step).norm(), 1e-9);
  aims.reset();
  EXPECT_LT((aims.at(goal)->followed_mm - *scene.grip_mm()).norm(), 1e-9) << "another operation holds something else";
}

// Else the fingertips close on the cube below, which is wider, and lift both.
TEST(Aims, GripASmallCubeSoHighThatTheFingertipsClearTheCubeBelow) {
  const CoordinatorOptions options;
  TaskDomain domain = TaskDomain::read(source_dir() + "/domains/sizes.scm").value();
  domain.use_cubes(60, {{"circle", 40}, {"square", 60}});
  Scene scene(options, domain);
  scene.take_camera(CameraModel());
  scene.take_pose(tool_pose({450, 100, 200}, 180, 0, 0));
  Aims aims(options, domain, scene);
  scene.take_look(1, look_at({{"circle", {470, 100, 80}}, {"square", {480, 100, 30}}}), false);
  const Aim aim = aims.at("circle"_sym).value();
  const double grip_mm = aim.grip_height_mm + aim.wanted_mm.z() - aim.followed_mm.z();
  EXPECT_GE(grip_mm, 60 + GripperGeometry::finger_below_mm);
  EXPECT_LT(grip_mm, 60 + GripperGeometry::finger_below_mm + 5);
}

class KnockedCamera : public testing::Test {
 protected:
  KnockedCamera() {
    scene.take_camera(CameraModel());
    scene.take_arm(true);
  }
  // The tool rests there, and its mark is seen so far off from where the arm says.
  void see_tool_at(double x_mm, const Eigen::Vector3d& off_mm) {
    move_tool_to(x_mm);
    scene.take_look(++frame, look_at({{options.gripper.mark, by_arm() - scene.mark_to_front_mm() + off_mm}}), true);
  }
  Eigen::Vector3d grip_out_of_sight_at(double x_mm) {
    move_tool_to(x_mm);
    scene.take_look(++frame, look_at({}), false);
    return *scene.grip_mm();
  }
  void move_tool_to(double x_mm) {
    tool_x_mm = x_mm;
    scene.take_pose(tool_pose({x_mm, 100, 300}, 180, 0, 0));
  }
  Eigen::Vector3d by_arm() const { return {tool_x_mm + domain.cube_mm() / 2, 100, 300}; }

  const CoordinatorOptions options;
  const TaskDomain domain = TaskDomain::read(source_dir() + "/domains/blocks.scm").value();
  Scene scene{options, domain};
  double tool_x_mm = 0;
  std::int64_t frame = 0;
};

TEST_F(KnockedCamera, PlacesAGripperOutOfSightByHowFarTheArmsWordWasOffAtTwoPlaces) {
  const Eigen::Vector3d off(30, -35, 20);
  see_tool_at(450, off);
  see_tool_at(440, off);
  const Eigen::Vector3d placed = grip_out_of_sight_at(460);
  EXPECT_LT((placed - by_arm() - off).norm(), 1e-6);
}

TEST_F(KnockedCamera, IsNotInferredFromAnImageThatStandsStillWhileTheArmMoves) {
  see_tool_at(450, {0, 0, 0});
  see_tool_at(410, {40, 0, 0});
  see_tool_at(370, {80, 0, 0});
  const Eigen::Vector3d placed = grip_out_of_sight_at(460);
  EXPECT_LT((placed - by_arm()).norm(), 1e-6);
}

}  // namespace
}  // namespace pizarra::coordinator
