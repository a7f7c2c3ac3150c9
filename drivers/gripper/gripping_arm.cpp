#include "drivers/gripper/gripping_arm.hpp"

namespace pizarra::gripper {

Task<Result<void>> GrippingArm::take_control() {
  const Result<void> control = co_await arm_.take_control();
  if (!control) co_return control;
  reads_left_ = 0;
  Result<void> connected = co_await gripper_.connect();
  co_return connected;
}

Task<Result<void>> GrippingArm::start_gripper(double opening_mm) {
  const Result<void> started = co_await gripper_.start(opening_mm);
  if (!started) co_return started;
  reads_left_ = 0;
  last_.moving = true;
  co_return Result<void>();
}

Task<Result<arm::ArmReading>> GrippingArm::read() {
  Result<arm::ArmReading> reading = co_await arm_.read();
  if (!reading) co_return reading;
  if (last_.moving || reads_left_-- <= 0) {
    const Result<GripperReading> gripper = co_await gripper_.read();
    if (!gripper) {
      reads_left_ = 0;
      co_return fail(gripper);
    }
    last_ = *gripper;
    reads_left_ = reads_of_an_opening;
  }
  reading->opening_mm = last_.opening_mm;
  reading->gripper_moving = last_.moving;
  reading->gripped = last_.gripped;
  co_return reading;
}

}  // namespace pizarra::gripper
