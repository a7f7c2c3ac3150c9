// A driver of one's own as a plug-in: an arm of two turning axes whose controller is a few numbers in this file. Put
// the lines to your controller where it says so.

#include <algorithm>
#include <chrono>
#include <cmath>

#include "drivers/plugin/arm_plugin.hpp"

using namespace pizarra::plugin;
using Clock = std::chrono::steady_clock;

class MyArm : public Arm {
 public:
  // Ask the controller what it is.
  std::string type() override { return "my-arm"; }

  void take_control() override { controlled_ = true; }

  // Hand the waypoints to the controller, and come back once it has taken them.
  void start_move(const std::vector<Joints>& waypoints, double speed) override {
    if (!controlled_) throw Refused("not-in-control", "somebody else has control of the arm");
    if (read().moving) throw Refused("busy", "the arm moves already");
    from_ = here();
    to_ = waypoints.back();
    if (to_.size() != from_.size()) throw Refused("bad-joints", "this arm has as many axes as its file says");
    double furthest = 0;
    for (std::size_t axis = 0; axis < to_.size(); ++axis) {
      furthest = std::max(furthest, std::abs(to_[axis] - from_[axis]));
    }
    begun_ = Clock::now();
    takes_s_ = furthest / (degrees_per_s * std::max(speed, 0.01));
    stopped_ = false;
  }

  // The shortest way to the brake.
  void stop() override {
    stopped_ = read().moving;
    to_ = from_ = here();
    takes_s_ = 0;
  }

  void start_gripper(double opening_mm) override { opening_mm_ = opening_mm; }

  // What the controller says now.
  ArmState read() override { return {here(), part() < 1, stopped_, opening_mm_, false}; }

 private:
  static constexpr double degrees_per_s = 60;

  double part() const {
    const double s = std::chrono::duration<double>(Clock::now() - begun_).count();
    return takes_s_ > 0 ? std::min(1.0, s / takes_s_) : 1;
  }
  Joints here() const {
    Joints joints = from_;
    for (std::size_t axis = 0; axis < joints.size(); ++axis) joints[axis] += part() * (to_[axis] - from_[axis]);
    return joints;
  }

  bool controlled_ = false;
  bool stopped_ = false;
  double opening_mm_ = 0;
  double takes_s_ = 0;
  Clock::time_point begun_{};
  Joints from_ = {0, 0, 0, 0};
  Joints to_ = from_;
};

PIZARRA_ARM_PLUGIN(MyArm)
