#pragma once

// A gripper with registers, as GripperSetup lays them out: it is activated, goes where it is told, and stops at what is
// between its fingers. It moves the gripper of an arm: one of its own, or the simulated world's.
//
//   MovingArm body(executor, model);
//   GripperEmulator gripper(executor, body, GripperSetup());
//   gripper.obey("fault 11");             // what somebody beside it does
//
// Somebody beside it: `power on` and `off` (off: it is silent), `fault CODE`, 0 for none, which ends its being active;
// `refuse CODE`: every request is answered with this exception, 0 for none.
//
// Where it tells its state in the registers of Robotiq's two-finger grippers it repeats there, as these do, what it was
// told: that it is active, that it goes, and where. Its fingers' current is always told as 0.
//
// How far it is proven: it answers the examples of Robotiq's manuals and what ROS-Industrial's robotiq driver says
// octet by octet, and Debian's mbpoll and pymodbus. Never compared with hardware.

#include <optional>

#include "blackboard/time/executor.hpp"
#include "drivers/arm/arm_driver.hpp"
#include "drivers/gripper/gripper_registers.hpp"

namespace pizarra::simulation {

class GripperEmulator {
 public:
  // The body outlives it.
  GripperEmulator(Executor& executor, arm::ArmDriver& body, const forms::GripperSetup& setup);

  // Registers that it has, from the first to the last.
  const gripper::RegisterImage& orders() const { return orders_; }
  const gripper::RegisterImage& states() const { return states_; }
  // They have been written.
  void told(gripper::RegisterImage orders);

  // Failure: unknown-command.
  Result<void> obey(std::string_view words);
  bool powered() const { return powered_; }
  int exception() const { return exception_; }
  std::string status() const;
  std::string status_in_json() const;
  // Times that its fingers were sent anywhere.
  std::uint64_t closings() const { return sent_; }

 private:
  static constexpr Duration look_every = 20ms;
  static constexpr Duration activation_time = 200ms;
  Task<void> live();
  void go_there();
  Task<void> send_to(double opening_mm);
  void look(const arm::ArmReading& reading);
  void tell();
  bool active() const;
  double wanted_mm() const;

  Executor& executor_;
  arm::ArmDriver& body_;
  const forms::GripperSetup setup_;
  gripper::RegisterImage orders_;
  gripper::RegisterImage states_;
  const bool echoes_;
  bool powered_ = true;
  int exception_ = 0;
  int fault_ = 0;
  std::optional<Time> active_since_;
  bool goes_ = false;     // it was sent somewhere and has not been seen to stand since
  bool delayed_ = false;  // it is to go as soon as it is active
  double opening_mm_ = 0;
  std::uint64_t sent_ = 0;
  Job sending_;
  Job living_;
};

}  // namespace pizarra::simulation
