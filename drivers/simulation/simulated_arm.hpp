#pragma once

// The simulated cell's arm and gripper as an ArmDriver: every call is one request over the device link.
//
//   SimulatedArm arm(link);
//   Result<void> control = co_await arm.take_control();

#include "drivers/arm/arm_driver.hpp"
#include "drivers/simulation/link.hpp"

namespace pizarra::simulation {

class SimulatedArm : public arm::ArmDriver {
 public:
  // The link outlives it. The device is `arm` or `second-arm`.
  explicit SimulatedArm(Link& link, std::string_view device = "arm") : link_(link), device_(Datum::symbol(device)) {}
  Task<Result<std::string>> identify() override;
  Task<Result<void>> take_control() override;
  Task<Result<void>> start_move(std::vector<arm::Joints> waypoints, double speed) override;
  Task<Result<void>> stop() override;
  Task<Result<void>> start_gripper(double opening_mm) override;
  Task<Result<arm::ArmReading>> read() override;

 private:
  Task<Result<void>> command(Datum request);
  Link& link_;
  const Datum device_;
  bool had_control_ = false;
};

}  // namespace pizarra::simulation
