#pragma once

// What a robot agent needs of an arm's controller. One implementation a controller; the simulated one is in
// drivers/simulation/.
//
// Lifecycle: identify() and take_control() once, then moves, one at a time; read() and stop() at any time, also while a
// move runs. Failures: not-in-control (what take_control() may mend: the pendant, a hold, an alarm, servos that are
// off), busy, joint-limit, not-finite, bad-joints, disconnected; refused (the controller's own code as subject).

#include <optional>
#include <vector>

#include "blackboard/time/task.hpp"
#include "drivers/arm/arm_model.hpp"
#include "lisp/result.hpp"

namespace pizarra {

struct ArmReading {
  Joints joints;
  bool moving;        // a move started and has not ended
  bool stopped;       // the last move was stopped before its end
  double opening_mm;  // the gripper's measured opening between the fingers
  bool gripper_moving;
  std::optional<Failure> why_stopped = {};  // where the controller says it
};

class ArmDriver {
 public:
  virtual ~ArmDriver() = default;
  // The controller's arm type, as in ArmModel::type.
  virtual Task<Result<std::string>> identify() = 0;
  virtual Task<Result<void>> take_control() = 0;
  // Starts a move through the waypoints (joint interpolation between them, in what the axes read), at `speed` 0..1 of
  // the axes' speeds, and answers once it is accepted.
  virtual Task<Result<void>> start_move(std::vector<Joints> waypoints, double speed) = 0;
  virtual Task<Result<void>> stop() = 0;
  virtual Task<Result<void>> start_gripper(double opening_mm) = 0;
  virtual Task<Result<ArmReading>> read() = 0;
};

}  // namespace pizarra
