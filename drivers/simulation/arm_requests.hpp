#pragma once

// The requests to a simulated arm over the device link, the same for every arm of a world; world.hpp lists the
// requests.
//
//   Result<Message> answer = co_await answer_arm(arm, request, executor.now());

#include "drivers/arm/arm_driver.hpp"
#include "drivers/simulation/link.hpp"
#include "drivers/simulation/physics/physical_cell.hpp"

namespace pizarra::simulation {

// The arm among the world's cubes.
class PhysicalArm : public arm::ArmDriver {
 public:
  PhysicalArm(Cell& cell, std::string type) : cell_(cell), type_(std::move(type)) {}
  Task<Result<std::string>> identify() override;
  Task<Result<void>> take_control() override;
  Task<Result<void>> release_control() override;
  Task<Result<void>> start_move(std::vector<arm::Joints> waypoints, double speed) override;
  Task<Result<void>> stop() override;
  Task<Result<void>> start_gripper(double opening_mm) override;
  Task<Result<arm::ArmReading>> read() override;

 private:
  Result<void> controlled() const;

  Cell& cell_;
  const std::string type_;
  bool controlled_ = false;
};

// `now`: when the arm is as it reads. Failures: bad-request, and the arm's.
Task<Result<Message>> answer_arm(arm::ArmDriver& arm, Datum request, Time now);

}  // namespace pizarra::simulation
