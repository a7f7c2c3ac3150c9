#pragma once

// An arm's driver as a plug-in (plugin.hpp).
//
//   class MyArm : public pizarra::plugin::Arm { ... };
//   PIZARRA_ARM_PLUGIN(MyArm)
//
// `(arm "my-arm.scm" (plugin "libmyarm.so"))` in a cell file has it driven. Angles and lengths are in what the arm
// file's axes read.

#include <vector>

#include "drivers/plugin/plugin.hpp"

namespace pizarra::plugin {

using Joints = std::vector<double>;

struct ArmState {
  Joints joints;
  bool moving = false;   // a move started and has not ended
  bool stopped = false;  // the last move was stopped before its end
  double opening_mm = 0;
  bool gripper_moving = false;
};

class Arm {
 public:
  virtual ~Arm() = default;
  // The controller's arm type, as the arm file calls it.
  virtual std::string type() = 0;
  // Nothing else resets an alarm, releases a brake or switches servos on.
  virtual void take_control() = 0;
  // Gives the arm back to whoever stands beside it: the servos go off.
  virtual void release_control() {}
  // Begins to move through the waypoints, at `speed` 0..1 of the axes' speeds, and comes back once that is accepted.
  virtual void start_move(const std::vector<Joints>& waypoints, double speed) = 0;
  virtual void stop() = 0;
  virtual void start_gripper(double opening_mm) = 0;
  virtual ArmState read() = 0;
};

}  // namespace pizarra::plugin

#define PIZARRA_ARM_PLUGIN(CLASS)                                 \
  extern "C" const int pizarra_plugin_abi = pizarra::plugin::abi; \
  extern "C" pizarra::plugin::Arm* pizarra_make_arm() { return new CLASS; }
