#pragma once

// An arm of any driver with a gripper that has a controller of its own, as one arm.
//
//   GrippingArm both(executor, arm, gripper);
//
// Neither waits for the other. Moves, stops and states are the arm's alone, whatever becomes of the gripper, which is
// asked beside them: while its fingers move as often as it answers, else at every tenth reading. The reading has the
// gripper's last answer, or the reason why there is none.
//
// take_control() takes the arm's first, and then has the gripper ready to move: not-in-control where that fails, and
// the arm can be moved all the same. power_up() waits for the arm alone; an opening that is ordered while the gripper
// is still being activated begins after that.

#include "blackboard/time/executor.hpp"
#include "drivers/arm/arm_driver.hpp"
#include "drivers/gripper/gripper_driver.hpp"

namespace pizarra::gripper {

class GrippingArm : public arm::ArmDriver {
 public:
  // All outlive it.
  GrippingArm(Executor& executor, arm::ArmDriver& arm, GripperDriver& gripper)
      : executor_(executor), arm_(arm), gripper_(gripper) {}
  Task<Result<std::string>> identify() override { return arm_.identify(); }
  Task<Result<void>> power_up() override;
  Task<Result<void>> take_control() override;
  Task<Result<void>> release_control() override { return arm_.release_control(); }
  Task<Result<void>> start_move(std::vector<arm::Joints> waypoints, double speed) override {
    return arm_.start_move(std::move(waypoints), speed);
  }
  Task<Result<void>> stop() override { return arm_.stop(); }
  Task<Result<void>> start_gripper(double opening_mm) override;
  Task<Result<arm::ArmReading>> read() override;
  std::uint64_t states_heard() const override { return arm_.states_heard(); }
  Duration longest_silence() const override { return arm_.longest_silence(); }

 private:
  static constexpr int reads_of_an_opening = 10;
  static constexpr Duration look_again = 20ms;
  Task<void> ask();
  Task<void> activate();

  Executor& executor_;
  arm::ArmDriver& arm_;
  GripperDriver& gripper_;
  GripperReading last_{};
  std::optional<Failure> trouble_ = Failure{"disconnected", "the gripper has not been asked yet", {}, {}};
  int reads_left_ = 0;  // until the gripper is asked again
  Job asking_;
  Job activating_;
};

}  // namespace pizarra::gripper
