#pragma once

// The visual servo: one look's errors in, the arm's next motion out. It remembers nothing, so an object that is moved
// meanwhile is followed by itself.
//
// Its five states are the thesis':
//   0  up, when there is sideways to go and the gripper is below the clearance
//   1  across: turn axis 1 until the mark stands at the right pixel x
//   2  along: extend or retract until it stands at the right depth
//   3  approach: down until the fine zone, in pixel y, a step at a time
//   4  fine alignment with low gain, then down until the distance is below the threshold
//
// State 4 aligns by TURN when the error across is coarse, and by MOVE_H when it is fine.
// States 0-3 are coarse: they go the whole way that the errors tell.

#include <string_view>

namespace pizarra::coordinator {

// The way that the mark still has to go. Taken along the arm's own directions, so that a turn does not disturb the
// depth nor an extension the pixel x.
struct ServoErrors {
  double across_mm;     // positive: the target is to the right
  double bearing_deg;   // the same as a turn of axis 1, positive right
  double along_mm;      // positive: further out from the arm
  double down_mm;       // positive: below
  double clearance_mm;  // how far the gripper is below the height that is safe to travel at; not positive: above it
};

// The errors as the thesis states them, for people: pixels at the target's depth, and mm of depth.
struct ServoPixels {
  double x_px;
  double y_px;
  double depth_mm;
};

struct ServoLimits {
  static constexpr double coarse_mm = 4;      // beyond it, across and along are corrected before going down
  static constexpr double follow_mm = 14;     // beyond it, the gripper goes up first
  static constexpr double fine_zone_mm = 75;  // the last part of the way down; above it the fingers touch nothing
  static constexpr double step_mm = 90;       // the longest step of the approach
  static constexpr double fine_step_mm = 40;
  static constexpr double turn_mm = 3;    // state 4: beyond it TURN, else MOVE_H
  static constexpr double fine_mm = 0.8;  // state 4: good enough across and along
  static constexpr double done_mm = 0.7;  // state 4: good enough in height
  static constexpr double fine_gain = 0.8;
};

struct ServoCommand {
  enum class Motion { up, down, turn, extend, move_h, done };
  int state;
  Motion motion;
  double amount;  // mm, or degrees for a turn; positive is right for turn and move_h, outwards for extend
  bool operator==(const ServoCommand&) const = default;
};

// `descend` false: states 0-2 only, to align without going down.
ServoCommand servo_command(const ServoErrors& errors, bool descend);

// Whether the way sideways that the command before was to go is still to go: the arm's own limits ended it.
bool has_stalled(const ServoCommand& command, const ServoCommand& before);

}  // namespace pizarra::coordinator
