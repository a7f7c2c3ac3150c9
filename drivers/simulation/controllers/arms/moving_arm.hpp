#pragma once

// An arm with nothing around it that moves in an executor's time, its gripper closing on nothing: what an emulated
// controller moves when it is not told to move the simulated world's.
//
//   MovingArm body(executor, model);

#include "blackboard/time/executor.hpp"
#include "drivers/arm/arm_driver.hpp"
#include "drivers/simulation/physics/arm_motion.hpp"

namespace pizarra::simulation {

class MovingArm : public arm::ArmDriver {
 public:
  MovingArm(Executor& executor, const arm::ArmModel& model)
      : executor_(executor), model_(model), motion_(model, model.ready), stepped_to_(executor.now()) {}
  Task<Result<std::string>> identify() override;
  Task<Result<void>> take_control() override;
  Task<Result<void>> start_move(std::vector<arm::Joints> waypoints, double speed) override;
  Task<Result<void>> stop() override;
  Task<Result<void>> start_gripper(double opening_mm) override;
  Task<Result<arm::ArmReading>> read() override;

 private:
  static constexpr Duration step_time = 4ms;
  static constexpr double fingers_mm_s = 60;
  static constexpr double widest_mm = 100;
  // Nobody sees it move but those who ask: it catches up then.
  void catch_up();

  Executor& executor_;
  const arm::ArmModel& model_;
  ArmMotion motion_;
  Time stepped_to_;
  double opening_mm_ = widest_mm;
  double wanted_mm_ = widest_mm;
};

}  // namespace pizarra::simulation
