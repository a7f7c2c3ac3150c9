#pragma once

// A person's hand in the cell. It leads a cube along a path: it sets the cube's speed at every step, so the cube pushes
// whatever it meets, and a cube that lags too far slips out of the hand. Or it strikes with its fist. Afterwards it
// waits a moment for things to settle.
//
//   Hand hand(physics, gripper);
//   Result<void> begun = hand.push(cube, 0, 50);
//   while (hand.busy()) { hand.step(1.0 / 240); physics.step(); }

#include "drivers/simulation/physics/gripper.hpp"

namespace pizarra::simulation {

class Hand {
 public:
  Hand(Physics& physics, Gripper& gripper);

  // Each fails with `busy` while the hand does something. Positions are of the cube's centre.
  Result<void> push(DynamicId cube, double dx_mm, double dy_mm);
  // The same at one speed from beginning to end.
  Result<void> slide(DynamicId cube, double dx_mm, double dy_mm, double speed_mm_s);
  Result<void> place(DynamicId cube, double x_mm, double y_mm);
  Result<void> stack(DynamicId cube, DynamicId on);
  // About the vertical, where it is: it shows another face then.
  Result<void> turn(DynamicId cube, double anticlockwise_deg);
  Result<void> steal(DynamicId cube);
  // In the way: it is lifted to that place, held there, and put back.
  Result<void> hold(DynamicId cube, const Eigen::Vector3d& at_mm, double seconds);
  Result<void> remove(DynamicId cube);
  // The cube is away; it comes from above. Failure busy, also while the gripper stands over the place.
  Result<void> add(DynamicId cube, double x_mm, double y_mm);
  Result<void> knock(DynamicId cube);

  void step(double seconds);
  bool busy() const { return job_ != Job::none; }
  // The cube in the hand.
  std::optional<DynamicId> carried() const;
  // Where the fist is seen, while there is one.
  std::optional<Eigen::Vector3d> fist_mm() const { return fist_seen_; }

 private:
  enum class Job { none, slide, carry, strike, watch };
  struct Leg {
    Eigen::Vector3d to_mm;
    double seconds;
    bool even = false;  // at one speed, in place of a gentle start and end
  };

  Result<void> begin(Job job, std::optional<DynamicId> cube, const Eigen::Vector3d& from_mm);
  void add_leg(const Eigen::Vector3d& to_mm, double speed_mm_s);
  void put_down(DynamicId cube, const Eigen::Vector3d& on_mm);
  double carry_height(DynamicId cube) const;
  double support_height(DynamicId cube, double x_mm, double y_mm) const;
  bool run_up_is_free(DynamicId struck, const Eigen::Vector3d& start_mm) const;
  Eigen::Vector3d wanted(double seconds_from_now) const;
  void lead(double seconds);
  void end();
  void watch(double seconds);

  Physics& physics_;
  Gripper& gripper_;
  KinematicId fist_;
  Job job_ = Job::none;
  DynamicId cube_ = 0;
  bool takes_away_ = false;  // the cube is gone at the end
  // How a carried cube is to be turned once it has been lifted; none: as it stands straight.
  std::optional<Eigen::Matrix3d> turned_ = {};
  Eigen::Vector3d from_mm_ = Eigen::Vector3d::Zero();
  std::vector<Leg> legs_;
  std::size_t leg_ = 0;
  double leg_time_s_ = 0;
  std::optional<Eigen::Vector3d> fist_seen_;
};

}  // namespace pizarra::simulation
