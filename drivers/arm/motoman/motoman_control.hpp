#pragma once

// Takes and gives back a Motoman controller, and says why its arm does not move.
//
//   MotomanControl control(executor, link);
//   const Result<void> taken = co_await control.take();
//   const Result<void> ready = co_await control.ready_to_move(status);
//
// take() resets alarms, ends the driver's own hold and switches the servos on; not at the pendant's word, whose TEACH
// refuses it. None of the protocols has a bit of the emergency stop: with it pressed the servos are off and do not come
// on. Failures: not-in-control, and those of the line.

#include <optional>

#include "blackboard/time/executor.hpp"
#include "drivers/arm/arm_driver.hpp"
#include "drivers/arm/motoman/motoman_link.hpp"

namespace pizarra::arm {

// Neither locked, held, without servos nor in alarm.
bool may_move(const MotomanStatus& status);
// A line's failure as the agent is told it.
std::unexpected<Failure> lost(const Failure& why);

class MotomanControl {
 public:
  // Both outlive it.
  MotomanControl(Executor& executor, MotomanLink& link) : executor_(executor), link_(link) {}
  Task<Result<void>> take();
  Task<Result<void>> release();
  // Ends the driver's own hold.
  Task<Result<void>> ready_to_move(MotomanStatus status);
  // Why an arm with this status does not move.
  Task<Failure> why_not(MotomanStatus status);

  // The trouble by the newest status that it looked at.
  Task<void> look(MotomanStatus status);
  const std::optional<ArmTrouble>& trouble() const { return trouble_; }

 private:
  Task<Result<void>> switch_on();

  Executor& executor_;
  MotomanLink& link_;
  std::optional<ArmTrouble> trouble_;
};

}  // namespace pizarra::arm
