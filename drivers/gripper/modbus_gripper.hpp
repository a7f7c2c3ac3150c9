#pragma once

// A gripper with registers at Modbus TCP (gripper_registers.hpp), as a GripperDriver.
//
//   ModbusClient client(executor, setup.place, setup.port, setup.unit);
//   ModbusGripper gripper(executor, client, setup);
//
// connect() activates it where it is not, which takes seconds and moves the fingers of some; a fault is reset so.
// Orders are written as one block of registers, and answers read as another: registers between those of its fields are
// written as 0.
//
// How far it is proven: with the emulated gripper of drivers/simulation/controllers/gripper/, which libmodbus serves,
// and with a gripper of the tests that shares no code with it; never with hardware. The registers are those of public
// drivers for Robotiq's two-finger grippers.

#include "drivers/gripper/gripper_driver.hpp"
#include "drivers/gripper/gripper_registers.hpp"
#include "drivers/gripper/modbus_client.hpp"

namespace pizarra::gripper {

class ModbusGripper : public GripperDriver {
 public:
  // The client outlives it.
  ModbusGripper(Executor& executor, ModbusClient& client, forms::GripperSetup setup)
      : executor_(executor), client_(client), setup_(std::move(setup)) {}
  Task<Result<void>> connect() override;
  Task<Result<void>> start(double opening_mm) override;
  Task<Result<GripperReading>> read() override;

 private:
  static constexpr Duration activation_time = 8s;
  static constexpr Duration starting_time = 100ms;  // until fingers that were sent somewhere are said to move
  static constexpr Duration look_again = 50ms;

  Task<Result<RegisterImage>> state();
  Task<Result<void>> tell(bool active, bool go, int target);
  Result<void> sound(const RegisterImage& state) const;

  Executor& executor_;
  ModbusClient& client_;
  forms::GripperSetup setup_;
  Time started_at_{};
};

}  // namespace pizarra::gripper
