#pragma once

// The parts of any arm's controller cabinet besides its protocol: a power switch, an emergency stop, a pendant that may
// have control, servos that come on with a delay, alarms and their reset, holds, a speed override; and the arm.
//
// Lifecycle: made with power on and the servos off, the arm where it is. obey() takes the actions of a person beside
// the cabinet; the other functions are for the protocol; what an arm may not do now is a Refusal, which a protocol
// words in its own codes.
//
//   MovingArm body(executor, model);          // or the simulated world's arm, over the device link
//   ArmCabinet cabinet(executor, body, model);
//   cabinet.obey("pendant on");               // "estop on", "hold on", "alarm 4107", "override 50", "power off" ...
//   const Refusal refusal = co_await cabinet.move(waypoints, 0.5);
//
// A move that a hold, an alarm, the emergency stop or a loss of power ended is not taken up again by itself. An arm
// that lost its power while it moved has alarm 4107 when it is back: its encoders and its memory differ.

#include <deque>
#include <optional>

#include "blackboard/time/executor.hpp"
#include "drivers/arm/arm_driver.hpp"

namespace pizarra::simulation {

enum class Refusal : std::uint8_t {
  none,
  running,
  pendant,
  alarm,
  emergency,
  servo_off,
  pendant_hold,
  command_hold,
  out_of_range,
};

class ArmCabinet {
 public:
  static constexpr int power_lost_alarm = 4107;
  static constexpr int arm_lost_alarm = 4000;  // the body does not answer

  // The body outlives it.
  ArmCabinet(Executor& executor, arm::ArmDriver& body, const arm::ArmModel& model)
      : executor_(executor), body_(body), model_(model) {
    last_.joints = model.ready;
  }

  // Somebody beside it: `power`, `estop`, `pendant`, `hold` or `servo` with `on` or `off`; `alarm CODE`, 0 for none;
  // `override PERCENT`. Failures: unknown-command, refused.
  Result<void> obey(std::string_view words);

  // Through the waypoints at `speed` 0..1 of the axes' speeds, times the override.
  Task<Refusal> move(std::vector<arm::Joints> waypoints, double speed);
  // Brakes; nothing is held.
  Task<void> stop();
  // Refusals: pendant, emergency, alarm.
  Refusal servo(bool on);
  Refusal hold(bool on);
  Refusal reset();
  // Refused as a move is.
  Task<Refusal> grip(double opening_mm);
  // The reading of its encoders; where nobody knows, it has an alarm and says what it said last.
  Task<arm::ArmReading> read();

  const arm::ArmModel& model() const { return model_; }
  Executor& executor() { return executor_; }
  bool powered() const { return powered_; }
  bool pendant() const { return pendant_; }
  bool emergency() const { return emergency_; }
  bool pendant_hold() const { return pendant_hold_; }
  bool command_hold() const { return command_hold_; }
  bool servo() const { return servo_since_ && executor_.now() - *servo_since_ >= servo_delay; }
  // They were switched on a moment ago, and are not on yet.
  bool servo_comes_on() const { return servo_since_ && !servo(); }
  int alarm() const { return alarm_; }
  // The last hundred, the newest last.
  const std::deque<int>& past_alarms() const { return past_alarms_; }
  double speed_override() const { return override_; }
  // Why it does not move; none where it may.
  Refusal refusal() const;
  // How long it has had power, its servos have been on, and its arm was seen to move.
  struct WorkTimes {
    Duration power{};
    Duration servo{};
    Duration motion{};
  };
  WorkTimes work_times() const;
  // Moves begun that led anywhere else than where the arm stood, and where the last of them led.
  std::uint64_t moves() const { return moves_; }
  const arm::Joints& last_target() const { return last_target_; }

 private:
  static constexpr Duration servo_delay = 200ms;
  void switch_servos_off();
  Result<void> turn(std::string_view what, bool on);
  void power(bool on);
  void raise(int alarm);
  void remember(int alarm);
  void brake();
  Task<void> brake_and_look();

  Executor& executor_;
  arm::ArmDriver& body_;
  const arm::ArmModel& model_;
  bool powered_ = true;
  bool pendant_ = false;
  bool emergency_ = false;
  bool pendant_hold_ = false;
  bool command_hold_ = false;
  int alarm_ = 0;
  std::deque<int> past_alarms_;
  double override_ = 1;
  std::optional<Time> servo_since_;
  WorkTimes worked_;  // before power and servos came on last
  Time power_since_{executor_.now()};
  Time seen_at_{executor_.now()};
  bool lost_in_motion_ = false;
  arm::ArmReading last_{};
  std::uint64_t moves_ = 0;
  arm::Joints last_target_;
  Job braking_;
};

}  // namespace pizarra::simulation
