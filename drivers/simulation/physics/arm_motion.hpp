#pragma once

// How the arm moves in time: along its waypoints, joint-interpolated, every axis within its speed, the pace ramped up
// and down at a constant acceleration (full axis speed in a quarter of a second).
//
//   ArmMotion motion(model, start);
//   Result<void> started = motion.start(waypoints, 0.5);
//   motion.step(1.0 / 240);
//   motion.joints();

#include <vector>

#include "drivers/arm/arm_model.hpp"
#include "lisp/result.hpp"

namespace pizarra::simulation {

class ArmMotion {
 public:
  static constexpr std::size_t max_waypoints = 10'000;

  ArmMotion(const arm::ArmModel& model, const arm::Joints& start) : model_(model), joints_(start) {}

  // `speed` 0..1 of the axes' speeds. Failures: busy, joint-limit, not-finite, bad-request.
  Result<void> start(std::vector<arm::Joints> waypoints, double speed);
  // Brakes; the move then ends stopped.
  void brake() { braking_ = moving_; }
  // Ends the move where the arm is, as a controller does that feels a collision.
  void halt();
  void step(double seconds);

  const arm::Joints& joints() const { return joints_; }
  bool moving() const { return moving_; }
  bool stopped() const { return stopped_; }

 private:
  void follow();

  const arm::ArmModel& model_;
  arm::Joints joints_;
  std::vector<arm::Joints> path_;  // begins where the arm stood
  std::vector<double> times_s_;    // when each would be passed at the full pace
  double along_s_ = 0;             // how far along times_s_ the arm is
  double pace_ = 0;                // 0..1
  double ramp_per_s_ = 0;          // change of pace
  bool moving_ = false;
  bool braking_ = false;
  bool stopped_ = false;
};

}  // namespace pizarra::simulation
