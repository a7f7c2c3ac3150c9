#pragma once

// The rigid bodies of the cell on Bullet: cubes that fall, slide and topple, a table, and kinematic things (palm,
// fingers, a fist) that are moved from outside and push what they touch. Lengths mm, forces N; Bullet itself works in
// decimetres, which its tolerances suit best.
//
//   Physics physics(table);
//   const CubeId cube = physics.add_cube(pose, cube_shape(60));
//   const KinematicId palm = physics.add_kinematic({{.centre_mm = {0, 0, -100}, .half_mm = {20, 62, 20}}}, friction);
//   physics.move_kinematic(palm, tool);          // where it is at the step's beginning
//   physics.step();                              // 1/240 s
//
// A cube is held by a fixed joint to a kinematic body: friction alone creeps.

#include <Eigen/Geometry>
#include <btBulletDynamicsCommon.h>
#include <memory>
#include <optional>
#include <vector>

#include "drivers/simulation/gripper_shape.hpp"
#include "drivers/simulation/world_config.hpp"

namespace pizarra::simulation {

using Pose = Eigen::Isometry3d;  // mm, in the base frame
using CubeId = std::size_t;
using KinematicId = std::size_t;

inline constexpr int steps_per_second = 240;

class Physics {
 public:
  struct Contact {
    int points = 0;
    double depth_mm = 0;  // of the deepest point
  };

  explicit Physics(const TableConfig& table);
  ~Physics();
  Physics(const Physics&) = delete;
  Physics& operator=(const Physics&) = delete;

  // A cube, or whatever else moves by itself: it counts as one.
  CubeId add_cube(const Pose& pose, const BodyShape& shape);
  const BodyShape& shape(CubeId cube) const { return cubes_[cube].shape; }
  // As it lies, to its nearest own axis: from below to above, and the longest way across.
  double height_mm(CubeId cube) const;
  double width_mm(CubeId cube) const;
  std::size_t cubes() const { return cubes_.size(); }
  // A cube that is away keeps its number; it is brought back at rest.
  bool present(CubeId cube) const { return cubes_[cube].present; }
  void take_away(CubeId cube);
  void bring(CubeId cube, const Pose& pose);
  Pose pose(CubeId cube) const;
  Eigen::Vector3d velocity_mm_s(CubeId cube) const;
  Eigen::Vector3d spin_rad_s(CubeId cube) const;
  void set_velocity(CubeId cube, const Eigen::Vector3d& velocity_mm_s, const Eigen::Vector3d& spin_rad_s);

  KinematicId add_kinematic(const std::vector<Box>& boxes, double friction);
  void move_kinematic(KinematicId body, const Pose& pose);
  // A disabled body touches nothing; enabled again it appears where it is moved next, without speed.
  void enable_kinematic(KinematicId body, bool enabled);
  Contact contact(KinematicId body, CubeId cube) const;
  // Whether the two pass through each other.
  void set_ignored(KinematicId body, CubeId cube, bool ignored);

  // One joint at a time.
  void hold(KinematicId body, CubeId cube);
  void let_go();
  // The load on the joint in the last step; 0 where nothing is held.
  double hold_force_n() const;

  void step();
  // Nothing moves nor is about to: a step would change nothing.
  bool asleep() const;

 private:
  struct Cube {
    BodyShape shape;
    std::unique_ptr<btCollisionShape> collision;
    std::unique_ptr<btRigidBody> body;
    bool present = true;
  };
  struct Kinematic {
    std::vector<std::unique_ptr<btCollisionShape>> shapes;
    std::unique_ptr<btRigidBody> body;
    bool enabled = true;
    bool placed = false;  // moved at least once since it was enabled
    int still_steps = 0;
  };

  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_;
  btDbvtBroadphase broadphase_;
  btSequentialImpulseConstraintSolver solver_;
  btDiscreteDynamicsWorld world_;
  btBoxShape table_shape_;
  std::unique_ptr<btRigidBody> table_;
  std::vector<Cube> cubes_;
  std::vector<std::unique_ptr<Kinematic>> kinematics_;
  std::unique_ptr<btFixedConstraint> joint_;
  btJointFeedback joint_feedback_;
};

}  // namespace pizarra::simulation
