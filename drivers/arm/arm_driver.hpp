#pragma once

// The interface of a robot agent to an arm's controller. One implementation a controller; the simulated one is in
// drivers/simulation/.
//
// Lifecycle: identify(), then take_control() whenever somebody wants the arm's troubles cleared, then moves, one
// at a time; read() and stop() at any time, also while a move runs and before control is taken. Nothing but
// take_control() resets an alarm, releases a brake or switches servos on. Failures: not-in-control (what take_control()
// may mend: the pendant, a hold, an alarm, servos that are off), busy, joint-limit, not-finite, bad-joints,
// disconnected; refused (the controller's own code as subject).
//
//   const Result<void> control = co_await driver.take_control();
//   const Result<void> begun = co_await driver.start_move({joints}, 0.1);      // at a tenth of the axes' speeds
//   const Result<ArmReading> now = co_await driver.read();                     // until it moves no more
//
// Any of an arm's lines may fall silent by itself. stop() goes out at once by every line that still takes something,
// and states_heard() goes on counting, whatever read() or identify() wait for. So the robot agent notices by
// states_heard() that the arm moves unseen, and ends that by stop() (agents/robot/silence.hpp).

#include <cstdint>
#include <optional>
#include <vector>

#include "blackboard/time/clock.hpp"
#include "blackboard/time/task.hpp"
#include "drivers/arm/arm_model.hpp"
#include "lisp/result.hpp"

namespace pizarra::arm {

// Why a controller would not move its arm now.
struct ArmTrouble {
  enum class Kind : std::uint8_t {
    off,      // its servos or brakes, and nothing else
    stopped,  // somebody keeps it from moving: a pendant, a hold, an emergency stop
    fault,    // something is wrong with it: an alarm
  };
  Kind kind;
  Failure why;  // not-in-control, the controller's code as subject
};

struct ArmReading {
  Joints joints;
  bool moving;        // a move started and has not ended
  bool stopped;       // the last move was stopped before its end
  double opening_mm;  // the gripper's measured opening between the fingers
  bool gripper_moving;
  std::optional<Failure> why_stopped = {};  // where the controller says it
  std::optional<ArmTrouble> trouble = {};   // where the controller says it
  std::optional<bool> gripped = {};         // something stopped the fingers, where the gripper says it
  std::optional<Time> at = {};              // when the joints were so; none: when this was answered
  // Why the gripper says nothing of itself: opening and grip are not known.
  std::optional<Failure> gripper_trouble = {};
};

class ArmDriver {
 public:
  virtual ~ArmDriver() = default;
  // The controller's arm type, as in ArmModel::type; where its protocol does not say, the driver's own file's, unless
  // what it does say is not of that arm (unknown-arm).
  virtual Task<Result<std::string>> identify() = 0;
  virtual Task<Result<void>> take_control() = 0;
  // The same, when the controller is met for the first time. It does not wait for a slow device of the arm.
  virtual Task<Result<void>> power_up() { return take_control(); }
  // Undoes what take_control() did, so that people beside the arm may move it: the servos go off.
  virtual Task<Result<void>> release_control() { co_return Result<void>(); }
  // Starts a move through the waypoints (joint interpolation between them, in what the axes read), at `speed` 0..1 of
  // the axes' speeds, and answers once it is accepted.
  virtual Task<Result<void>> start_move(std::vector<Joints> waypoints, double speed) = 0;
  virtual Task<Result<void>> stop() = 0;
  virtual Task<Result<void>> start_gripper(double opening_mm) = 0;
  virtual Task<Result<ArmReading>> read() = 0;
  // How many states of its arm the controller has told so far.
  virtual std::uint64_t states_heard() const { return states_heard_; }
  // An arm that moves is stopped when no state has come for this long. A driver answers more only where its line is
  // too slow for it.
  virtual Duration longest_silence() const { return 150ms; }

 protected:
  void hear_state() { ++states_heard_; }

 private:
  std::uint64_t states_heard_ = 0;
};

}  // namespace pizarra::arm
