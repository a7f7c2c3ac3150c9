// What a grip bears, and why it is a joint with a limit of force: by friction alone the cube would not stay.

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "drivers/simulation/physics/gripper.hpp"

namespace pizarra::simulation {

namespace {

constexpr double step_s = 1.0 / steps_per_second;
constexpr double edge_mm = 60;
const Eigen::Vector3d place_mm(400, 0, 300);
const Eigen::Vector3d up(0, 0, 1);
const Eigen::Vector3d aside(1, 0, 0);

Pose cube_at(const Eigen::Vector3d& at_mm) {
  Pose pose = Pose::Identity();
  pose.translation() = at_mm;
  return pose;
}

// Straight down.
Pose tool_at(const Eigen::Vector3d& at_mm) {
  Pose pose = cube_at(at_mm);
  pose.linear() << 1, 0, 0, 0, -1, 0, 0, 0, -1;
  return pose;
}

// A cube in the air, in the fingers.
class Grip {
 public:
  Grip() {
    gripper_.command(0);
    for (int i = 0; i < steps_per_second && !gripper_.held(); ++i) {
      physics_.bring(cube_, cube_at(place_mm));
      step();
    }
    rest(0.5);
  }
  // The tool gains this speed every second, in that direction.
  void accelerate(const Eigen::Vector3d& m_s2, double seconds) {
    for (int i = 0; i < std::lround(seconds / step_s); ++i) {
      speed_mm_s_ += 1000 * step_s * m_s2;
      step();
    }
  }
  void rest(double seconds) { accelerate(Eigen::Vector3d::Zero(), seconds); }
  bool holds() const { return gripper_.held().has_value(); }
  double force_n() const { return physics_.hold_force_n(); }
  // How far the cube has come from where it is held.
  double off_mm() const { return (physics_.pose(cube_).translation() - at_mm_).norm(); }

 private:
  void step() {
    at_mm_ += step_s * speed_mm_s_;
    gripper_.step(tool_at(at_mm_), step_s);
    physics_.step();
  }

  Physics physics_{TableConfig{}};
  DynamicId cube_ = physics_.add_dynamic(cube_at(place_mm), cube_shape(edge_mm));
  Gripper gripper_{physics_};
  Eigen::Vector3d at_mm_ = place_mm;
  Eigen::Vector3d speed_mm_s_ = Eigen::Vector3d::Zero();
};

bool bears(const Eigen::Vector3d& m_s2) {
  Grip grip;
  EXPECT_TRUE(grip.holds());
  grip.accelerate(m_s2, 0.1);
  return grip.holds();
}

// The furthest that a cube comes within ten seconds from where two fingers squeeze it that stand still so deep in it.
double wander_by_friction_mm(double friction, double depth_mm) {
  Physics physics(TableConfig{});
  const DynamicId cube = physics.add_dynamic(cube_at(place_mm), cube_shape(edge_mm));
  const KinematicId left = physics.add_kinematic({gripper_shape::finger}, friction);
  const KinematicId right = physics.add_kinematic({gripper_shape::finger}, friction);
  const double aside_mm = (edge_mm + gripper_shape::finger_thickness_mm) / 2 - depth_mm;
  double furthest_mm = 0;
  for (int i = 0; i < 10 * steps_per_second; ++i) {
    physics.move_kinematic(left, tool_at(place_mm) * Eigen::Translation3d(0, -aside_mm, 0));
    physics.move_kinematic(right, tool_at(place_mm) * Eigen::Translation3d(0, aside_mm, 0));
    physics.step();
    furthest_mm = std::max(furthest_mm, (physics.pose(cube).translation() - place_mm).norm());
  }
  return furthest_mm;
}

}  // namespace

TEST(GripLoad, IsTheCubesWeightAtRestAndTheCubeStays) {
  Grip grip;
  EXPECT_NEAR(grip.force_n(), 9.81 * cube_mass_kg, 0.05);
  const double before_mm = grip.off_mm();
  grip.rest(10);
  EXPECT_TRUE(grip.holds());
  EXPECT_NEAR(grip.off_mm(), before_mm, 0.1);
}

TEST(GripLoad, IsBorneUpToThirtyNewtons) {
  EXPECT_TRUE(bears(165 * up));
  EXPECT_FALSE(bears(185 * up));
  EXPECT_TRUE(bears(170 * aside));
  EXPECT_FALSE(bears(200 * aside));
}

TEST(GripLoad, IsBorneWhereItIsGreaterForAMoment) {
  Grip grip;
  grip.accelerate(300 * up, 3 * step_s);
  grip.rest(0.1);
  EXPECT_TRUE(grip.holds());
}

TEST(GripLoad, WouldNotBeBorneByFrictionAlone) {
  for (const double friction : {0.2, 0.6, 1.0}) {
    for (const double depth_mm : {0.5, 1.0, 2.0}) {
      EXPECT_GT(wander_by_friction_mm(friction, depth_mm), 2) << friction << ", " << depth_mm << " mm deep";
    }
  }
}

}  // namespace pizarra::simulation
