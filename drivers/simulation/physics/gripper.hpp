#pragma once

// A parallel gripper: a palm with a marked plate, and two fingers that close at a finite speed, push what is between
// them, and hold it once it lies flat against both. It misses where nothing is between; what it holds is torn out by a
// force above `hold_limit_n` that lasts.
//
// States: open or closing on nothing -> squeezing (a cube touches both fingers) -> holding -> open.
//
//   Gripper gripper(physics);
//   gripper.command(50);
//   gripper.step(tool_pose, 1.0 / 240);           // before every physics step

#include "drivers/simulation/physics/physics.hpp"

namespace pizarra::simulation {

class Gripper {
 public:
  static constexpr double speed_mm_s = 80;  // of the opening
  static constexpr double hold_limit_n = 30;
  static constexpr int hold_limit_steps = 5;

  explicit Gripper(Physics& physics);

  // Clamped to what the gripper can do.
  void command(double opening_mm);
  void step(const Pose& tool, double seconds);

  double opening_mm() const { return opening_mm_; }
  bool moving() const { return moving_; }
  std::optional<DynamicId> held() const { return held_; }
  // Whether it opens, as it does when what it held is put down.
  bool opens() const { return moving_ && target_mm_ > opening_mm_; }
  // The cube is gone from between the fingers by another's doing.
  void lose();
  // The held cube slips out and falls, and the fingers close behind it. Does nothing where none is held.
  void slip();
  // The gripper passes through the cube until the two have parted.
  void let_pass(DynamicId cube);
  // Whether something of half that size would meet it on its way down from there.
  bool stands_over(const Eigen::Vector3d& from_mm, const Eigen::Vector3d& half_mm) const;
  // How hard palm, fingers and held cube press on the world: the depth to which they enter cubes they do not hold.
  double press_depth_mm() const;

 private:
  // From the middle to the middle of a finger.
  double finger_aside_mm() const;
  double finger_depth_mm() const;
  void close_by(double step_mm);
  std::optional<DynamicId> squeezed() const;
  void set_through(DynamicId cube, bool through);
  void part_from_passing(const Pose& tool);

  Physics& physics_;
  KinematicId palm_;
  KinematicId left_;
  KinematicId right_;
  Eigen::Vector3d grip_mm_ = Eigen::Vector3d::Zero();  // the tool, at the newest step
  double opening_mm_ = gripper_opening_mm;
  double target_mm_ = gripper_opening_mm;
  bool moving_ = false;
  double depth_before_mm_ = 0;  // how deep the fingers were in something when the command came
  std::optional<DynamicId> held_;
  std::optional<DynamicId> passing_;
  int overloaded_steps_ = 0;
};

}  // namespace pizarra::simulation
