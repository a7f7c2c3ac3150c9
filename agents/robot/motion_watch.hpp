#pragma once

// Watches an arm, or its fingers, until a motion has ended, and tells the board on the way where the arm is.
//
//   MotionWatch watch(executor, connection, facts, tell_period);
//   const Result<arm::ArmReading> ended = co_await watch.until_ended(MotionWatch::Of::arm, longest);
//
// Failures: fault where the motion lasts too long, and those of the connection.

#include "agents/robot/arm_connection.hpp"

namespace pizarra::robot {

class MotionWatch {
 public:
  static constexpr Duration poll_period = 20ms;  // at most
  static constexpr Duration patience = 2s;       // with a controller that does not answer meanwhile

  // All outlive it. The board is told so often while something changes.
  MotionWatch(Executor& executor, ArmConnection& arm, ArmFacts& facts, Duration tell_period)
      : executor_(executor), arm_(arm), facts_(facts), tell_period_(tell_period) {}

  enum class Of : std::uint8_t { arm, gripper };
  // Answers the reading that shows them at rest. What moves longer is told to stop.
  Task<Result<arm::ArmReading>> until_ended(Of what, Duration longest);
  // From here on it is due; until_ended() begins so by itself.
  void begin() { tell_at_ = executor_.now() + tell_period_; }
  // Where the controller was late with something new, it is told as soon as it comes.
  void tell_where_due();

 private:
  Task<void> tell();

  Executor& executor_;
  ArmConnection& arm_;
  ArmFacts& facts_;
  const Duration tell_period_;
  Time tell_at_{};
  bool telling_ = false;  // and it is not acknowledged yet
  Job on_the_way_;
};

}  // namespace pizarra::robot
