#pragma once

// The simulated cell's arm and gripper as an ArmDriver: every call is one request over the device link. A reading may
// have a sixth item, (alarm CODE): an alarm that take_control() alone resets.
//
//   SimulatedArm arm(link);
//   Result<void> control = co_await arm.take_control();

#include "drivers/arm/arm_driver.hpp"
#include "drivers/simulation/link.hpp"

namespace pizarra::simulation {

class SimulatedArm : public arm::ArmDriver {
 public:
  // The reaction where the other end has forgotten that this arm has control and has no alarm. A world that began anew
  // gives control again. Of a real arm its commander says whether it may be taken.
  enum class AfterLoss : std::uint8_t { take_control, fail };

  // The link outlives it. The device is `arm` or `second-arm`.
  explicit SimulatedArm(Link& link, std::string_view device = "arm", AfterLoss after_loss = AfterLoss::take_control)
      : link_(link), device_(Datum::symbol(device)), after_loss_(after_loss) {}
  Task<Result<std::string>> identify() override;
  Task<Result<void>> take_control() override;
  Task<Result<void>> release_control() override;
  Task<Result<void>> start_move(std::vector<arm::Joints> waypoints, double speed) override;
  Task<Result<void>> stop() override;
  Task<Result<void>> start_gripper(double opening_mm) override;
  Task<Result<arm::ArmReading>> read() override;

 private:
  Task<Result<void>> command(Datum request);
  Link& link_;
  const Datum device_;
  const AfterLoss after_loss_;
  bool had_control_ = false;
};

}  // namespace pizarra::simulation
