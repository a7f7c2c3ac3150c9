#pragma once

// Guards an arm, whoever commands it, against three things: its axes beyond their limits, or faster than they may be,
// or its grip centre out of the room it was given. Looked at with every reading, by the agent itself, without the
// board.
//
//   Guard guard(model);
//   if (const std::optional<Failure> why = guard.look(*reading.at, reading)) stop(*why);

#include <optional>

#include "agents/robot/work_volume.hpp"
#include "blackboard/time/clock.hpp"
#include "drivers/arm/arm_driver.hpp"

namespace pizarra::robot {

class Guard {
 public:
  // How much faster than its axis' speed a reading may seem, and over how long it is measured: readings come late.
  static constexpr double speed_slack = 1.5;
  static constexpr Duration speed_window = 100ms;

  explicit Guard(const arm::ArmModel& model, const std::optional<WorkVolume>& room = {}) : model_(model), room_(room) {}

  // A motion begins: an arm that stands out of its room may come back.
  void begin() { was_in_room_ = false; }
  // `at`: when the arm was as it reads. Failures `joint-limit`, `too-fast` (the subject is the axis, from 1) and
  // `out-of-room`.
  std::optional<Failure> look(Time at, const arm::ArmReading& reading);

 private:
  std::optional<Failure> look_at_speed(Time at, const arm::Joints& joints);

  const arm::ArmModel& model_;
  const std::optional<WorkVolume> room_;
  Time measured_at_{};
  arm::Joints measured_;
  bool was_in_room_ = false;
};

}  // namespace pizarra::robot
