#pragma once

// The operations that an arm needs of a gripper with a controller of its own, whichever line reaches it. One
// implementation a protocol; GrippingArm puts one onto an arm of any driver.
//
// Lifecycle: connect() whenever somebody takes control, which alone activates it or resets its fault; start() and
// read() at any time. Every call ends within a second or two, connect() within ten. Failures: not-finite, disconnected,
// bad-reply; refused, whose subject is the gripper's code; not-in-control, where it has a fault or cannot be activated.
//
//   const Result<void> ready = co_await gripper.connect();
//   const Result<void> begun = co_await gripper.start(40);
//   const Result<GripperReading> now = co_await gripper.read();      // until it moves no more; gripped: it holds it

#include "blackboard/time/task.hpp"
#include "lisp/result.hpp"

namespace pizarra::gripper {

struct GripperReading {
  double opening_mm;  // measured, between the fingers
  bool moving;
  bool gripped;  // something stopped the fingers before they were where they were sent
};

class GripperDriver {
 public:
  virtual ~GripperDriver() = default;
  // Finds it, and has it ready to move.
  virtual Task<Result<void>> connect() = 0;
  // Answers once the fingers begin; they end at the opening, or on what is between them.
  virtual Task<Result<void>> start(double opening_mm) = 0;
  virtual Task<Result<GripperReading>> read() = 0;
};

}  // namespace pizarra::gripper
