#pragma once

// The rigid bodies of the cell on Bullet: dynamic ones (cubes, bricks, cylinders) that fall, slide and topple, a table,
// and kinematic ones (palm, fingers, a fist) that are moved from outside and push what they touch. Lengths mm, forces
// N; Bullet itself works in decimetres, which its tolerances suit best.
//
//   Physics physics(table);
//   const DynamicId cube = physics.add_dynamic(pose, cube_shape(60));
//   const KinematicId palm = physics.add_kinematic({{.centre_mm = {0, 0, -100}, .half_mm = {20, 62, 20}}}, friction);
//   physics.move_kinematic(palm, tool);          // where it is at the step's beginning
//   physics.step();                              // 1/240 s
//
// A dynamic body is held by a fixed joint to a kinematic body: friction alone creeps.

#include <Eigen/Geometry>
#include <btBulletDynamicsCommon.h>
#include <memory>
#include <optional>
#include <vector>

#include "drivers/simulation/gripper_shape.hpp"
#include "drivers/simulation/world_config.hpp"

namespace pizarra::simulation {

using Pose = Eigen::Isometry3d;  // mm, in the base frame
using DynamicId = std::size_t;
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

  // All weigh the same.
  DynamicId add_dynamic(const Pose& pose, const BodyShape& shape);
  const BodyShape& shape(DynamicId id) const { return dynamics_[id].shape; }
  // As it lies, to its nearest own axis: from below to above, and the longest way across.
  double height_mm(DynamicId id) const;
  double width_mm(DynamicId id) const;
  std::size_t dynamics() const { return dynamics_.size(); }
  // A body that is away keeps its number; it is brought back at rest.
  bool present(DynamicId id) const { return dynamics_[id].present; }
  void take_away(DynamicId id);
  void bring(DynamicId id, const Pose& pose);
  Pose pose(DynamicId id) const;
  Eigen::Vector3d velocity_mm_s(DynamicId id) const;
  Eigen::Vector3d spin_rad_s(DynamicId id) const;
  void set_velocity(DynamicId id, const Eigen::Vector3d& velocity_mm_s, const Eigen::Vector3d& spin_rad_s);

  KinematicId add_kinematic(const std::vector<Box>& boxes, double friction);
  void move_kinematic(KinematicId id, const Pose& pose);
  // A disabled body touches nothing; enabled again it appears where it is moved next, without speed.
  void enable_kinematic(KinematicId id, bool enabled);
  Contact contact(KinematicId kinematic, DynamicId dynamic) const;
  // Whether the two pass through each other.
  void set_ignored(KinematicId kinematic, DynamicId dynamic, bool ignored);

  // One joint at a time.
  void hold(KinematicId kinematic, DynamicId dynamic);
  void let_go();
  // The load on the joint in the last step; 0 where nothing is held.
  double hold_force_n() const;

  void step();
  // Nothing moves nor is about to: a step would change nothing.
  bool asleep() const;

 private:
  struct Dynamic {
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
  std::vector<Dynamic> dynamics_;
  std::vector<std::unique_ptr<Kinematic>> kinematics_;
  std::unique_ptr<btFixedConstraint> joint_;
  btJointFeedback joint_feedback_;
};

}  // namespace pizarra::simulation
