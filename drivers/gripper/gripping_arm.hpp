#pragma once

// An arm of any driver with a gripper that has a controller of its own, as one arm.
//
//   GrippingArm both(arm, gripper);
//
// Moves and stops are the arm's alone. The gripper is asked while its fingers move and at every tenth reading else; one
// that cannot be asked is the failure of the reading, for what the arm holds is then not known.

#include "drivers/arm/arm_driver.hpp"
#include "drivers/gripper/gripper_driver.hpp"

namespace pizarra::gripper {

class GrippingArm : public arm::ArmDriver {
 public:
  // Both outlive it.
  GrippingArm(arm::ArmDriver& arm, GripperDriver& gripper) : arm_(arm), gripper_(gripper) {}
  Task<Result<std::string>> identify() override { return arm_.identify(); }
  Task<Result<void>> take_control() override;
  Task<Result<void>> start_move(std::vector<arm::Joints> waypoints, double speed) override {
    return arm_.start_move(std::move(waypoints), speed);
  }
  Task<Result<void>> stop() override { return arm_.stop(); }
  Task<Result<void>> start_gripper(double opening_mm) override;
  Task<Result<arm::ArmReading>> read() override;

 private:
  static constexpr int reads_of_an_opening = 10;

  arm::ArmDriver& arm_;
  GripperDriver& gripper_;
  GripperReading last_{};
  int reads_left_ = 0;  // until the gripper is asked again
};

}  // namespace pizarra::gripper
