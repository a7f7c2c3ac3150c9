#pragma once

// The present faults of a cell's devices. The cell's lines to them bring these about (device_line.hpp). Times are the
// world's.
//
//   DeviceFaults faults;
//   faults.arm_away_until = time.now() + 2s;
//   faults = {};                                    // all is well again

#include <optional>

#include "blackboard/time/clock.hpp"

namespace pizarra::chaos {

struct DeviceFaults {
  Time arm_away_until{};   // nothing reaches the arm's controller, nor comes from it
  Time acks_late_until{};  // what it answers to commands comes after `ack_delay`
  Duration ack_delay{};
  Time acks_twice_until{};  // it comes once more, so long after the first
  Duration second_ack_after{};
  Time pendant_until{};       // it takes no motion
  bool alarm = false;         // nor before control of it is taken anew
  Time sensor_stuck_until{};  // the gripper's opening reads as it did
  std::optional<double> stuck_at_mm;
  Time frames_dropped_until{};  // none comes
  Time frames_frozen_until{};   // each shows what the one before it did
  Time frames_doubled_until{};  // each comes once more
  Time frames_late_until{};     // each comes after `frame_delay`
  Duration frame_delay{};
  Time hidden_until{};   // a stripe of the image is covered
  double hidden_at = 0;  // where it begins, of its width
  Time jumps_until{};    // the image is shifted by so many pixels
  int jump_px = 0;
  Time light_until{};  // the image is so many times as bright
  double light = 1;
};

}  // namespace pizarra::chaos
