#include "drivers/gripper/gripping_arm.hpp"

namespace pizarra::gripper {

Task<Result<void>> GrippingArm::power_up() {
  const Result<void> up = co_await arm_.power_up();
  if (up) activating_ = executor_.spawn(activate());
  co_return up;
}

Task<void> GrippingArm::activate() {
  [[maybe_unused]] const Result<void> connected = co_await gripper_.connect();
  reads_left_ = 0;
}

Task<Result<void>> GrippingArm::take_control() {
  activating_ = Job();
  const Result<void> control = co_await arm_.take_control();
  if (!control) co_return control;
  const Result<void> connected = co_await gripper_.connect();
  reads_left_ = 0;
  if (connected) co_return connected;
  const Failure& why = connected.error();
  co_return fail("not-in-control", "the arm can be moved, and its gripper cannot: " + why.sentence, why.subject);
}

Task<Result<void>> GrippingArm::start_gripper(double opening_mm) {
  while (!activating_.done()) co_await sleep(executor_, look_again);
  const Result<void> started = co_await gripper_.start(opening_mm);
  if (!started) trouble_ = started.error();
  if (!started) co_return started;
  // An answer to a question asked before it began does not count.
  asking_ = Job();
  reads_left_ = 0;
  trouble_.reset();
  last_.moving = true;
  co_return Result<void>();
}

Task<void> GrippingArm::ask() {
  const Result<GripperReading> gripper = co_await gripper_.read();
  trouble_.reset();
  if (gripper) {
    last_ = *gripper;
  } else {
    trouble_ = gripper.error();
  }
}

Task<Result<arm::ArmReading>> GrippingArm::read() {
  Result<arm::ArmReading> reading = co_await arm_.read();
  if (!reading) co_return reading;
  const bool due = last_.moving || reads_left_-- <= 0;
  if (due && asking_.done()) {
    reads_left_ = reads_of_an_opening;
    asking_ = executor_.spawn(ask());
  }
  reading->opening_mm = last_.opening_mm;
  reading->gripper_moving = last_.moving;
  reading->gripped = last_.gripped;
  reading->gripper_trouble = trouble_;
  co_return reading;
}

}  // namespace pizarra::gripper
