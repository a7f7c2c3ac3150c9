#include "drivers/simulation/physics/gripper.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace pizarra::simulation {

namespace {

using Eigen::Vector3d;

constexpr double finger_friction = 0.2;
// A face lies flat against a finger when it touches it in this many points. What is round touches it along a line.
constexpr int flat_points = 3;
constexpr int line_points = 1;
// Deeper than this the fingers are stopped by what is between them, flat or not.
constexpr double jammed_mm = 1.5;
// At this distance from the fingers and the palm a cube has parted from them.
constexpr double parted_mm = 3;

// The box around the cube along the tool's axes, which other boxes along them are compared with.
Eigen::AlignedBox3d box_around(const Pose& cube_in_tool, const Vector3d& size_mm) {
  const Vector3d half = cube_in_tool.linear().cwiseAbs() * size_mm / 2;
  return {cube_in_tool.translation() - half, cube_in_tool.translation() + half};
}

bool is_apart(const Eigen::AlignedBox3d& cube, const Box& part, double aside_mm) {
  const Vector3d centre = part.centre_mm + aside_mm * Vector3d::UnitY();
  const Vector3d half = part.half_mm + Vector3d::Constant(parted_mm);
  return !cube.intersects(Eigen::AlignedBox3d(centre - half, centre + half));
}

}  // namespace

Gripper::Gripper(Physics& physics)
    : physics_(physics),
      palm_(physics.add_kinematic({gripper_shape::palm, gripper_shape::plate}, finger_friction)),
      left_(physics.add_kinematic({gripper_shape::finger}, finger_friction)),
      right_(physics.add_kinematic({gripper_shape::finger}, finger_friction)) {}

void Gripper::command(double opening_mm) {
  target_mm_ = std::clamp(opening_mm, 0.0, gripper_opening_mm);
  if (target_mm_ > opening_mm_) lose();
  // A gripper that holds something cannot close further.
  moving_ = target_mm_ != opening_mm_ && !held_;
  depth_before_mm_ = finger_depth_mm();
}

void Gripper::step(const Pose& tool, double seconds) {
  if (moving_ && target_mm_ > opening_mm_) {
    opening_mm_ = std::min(target_mm_, opening_mm_ + speed_mm_s * seconds);
    moving_ = opening_mm_ != target_mm_;
  } else if (moving_) {
    close_by(speed_mm_s * seconds);
  }
  part_from_passing(tool);
  overloaded_steps_ = physics_.hold_force_n() > hold_limit_n ? overloaded_steps_ + 1 : 0;
  if (overloaded_steps_ >= hold_limit_steps) lose();

  grip_mm_ = tool.translation();
  physics_.move_kinematic(palm_, tool);
  const double aside_mm = finger_aside_mm();
  physics_.move_kinematic(left_, tool * Eigen::Translation3d(0, -aside_mm, 0));
  physics_.move_kinematic(right_, tool * Eigen::Translation3d(0, aside_mm, 0));
}

void Gripper::close_by(double step_mm) {
  const std::optional<DynamicId> cube = squeezed();
  if (cube) {
    held_ = cube;
    physics_.hold(palm_, *cube);
    set_through(*cube, true);
    moving_ = false;
    return;
  }
  const double jam_mm = finger_depth_mm();
  if (jam_mm > std::max(2 * jammed_mm, depth_before_mm_ + jammed_mm)) {
    moving_ = false;
    return;
  }
  opening_mm_ = std::max(target_mm_, opening_mm_ - step_mm);
  moving_ = opening_mm_ != target_mm_;
}

double Gripper::finger_aside_mm() const { return (opening_mm_ + gripper_shape::finger_thickness_mm) / 2; }

double Gripper::finger_depth_mm() const {
  double deepest = 0;
  for (DynamicId cube = 0; cube < physics_.dynamics(); ++cube) {
    if (!physics_.present(cube) || cube == held_) continue;
    deepest = std::max({deepest, physics_.contact(left_, cube).depth_mm, physics_.contact(right_, cube).depth_mm});
  }
  return deepest;
}

std::optional<DynamicId> Gripper::squeezed() const {
  for (DynamicId cube = 0; cube < physics_.dynamics(); ++cube) {
    if (!physics_.present(cube)) continue;
    const Physics::Contact left = physics_.contact(left_, cube);
    const Physics::Contact right = physics_.contact(right_, cube);
    if (left.points == 0 || right.points == 0) continue;
    const int needed = physics_.shape(cube).is_round ? line_points : flat_points;
    const bool flat = left.points >= needed && right.points >= needed;
    const bool jammed = left.depth_mm > jammed_mm && right.depth_mm > jammed_mm;
    if (flat || jammed) return cube;
  }
  return std::nullopt;
}

void Gripper::lose() {
  if (!held_) return;
  physics_.let_go();
  set_through(*held_, false);
  held_.reset();
  overloaded_steps_ = 0;
}

void Gripper::slip() {
  if (!held_) return;
  const DynamicId cube = *held_;
  lose();
  let_pass(cube);
  target_mm_ = 0;
  moving_ = true;
  depth_before_mm_ = finger_depth_mm();
}

void Gripper::let_pass(DynamicId cube) {
  if (passing_ && passing_ != cube) set_through(*passing_, false);
  set_through(cube, true);
  passing_ = cube;
}

void Gripper::part_from_passing(const Pose& tool) {
  if (!passing_) return;
  if (physics_.present(*passing_)) {
    const Pose in_tool = tool.inverse() * physics_.pose(*passing_);
    const Eigen::AlignedBox3d cube = box_around(in_tool, physics_.shape(*passing_).size_mm);
    const double aside_mm = finger_aside_mm();
    const bool is_clear = is_apart(cube, gripper_shape::finger, -aside_mm) &&
                          is_apart(cube, gripper_shape::finger, aside_mm) && is_apart(cube, gripper_shape::palm, 0) &&
                          is_apart(cube, gripper_shape::plate, 0);
    if (!is_clear) return;
  }
  set_through(*passing_, false);
  passing_.reset();
}

void Gripper::set_through(DynamicId cube, bool through) {
  for (const KinematicId body : {palm_, left_, right_}) physics_.set_ignored(body, cube, through);
}

bool Gripper::stands_over(const Eigen::Vector3d& from_mm, const Eigen::Vector3d& half_mm) const {
  const double tip_mm = gripper_shape::finger.centre_mm.z() + gripper_shape::finger.half_mm.z();
  const double aside_mm = (grip_mm_ - from_mm).head<2>().norm();
  return aside_mm < gripper_shape::palm.half_mm.y() + half_mm.head<2>().norm() &&
         grip_mm_.z() - tip_mm < from_mm.z() + half_mm.z();
}

double Gripper::press_depth_mm() const {
  double deepest = finger_depth_mm();
  for (DynamicId cube = 0; cube < physics_.dynamics(); ++cube) {
    if (!physics_.present(cube) || cube == held_) continue;
    deepest = std::max(deepest, physics_.contact(palm_, cube).depth_mm);
  }
  return deepest;
}

}  // namespace pizarra::simulation
