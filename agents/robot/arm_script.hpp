#pragma once

// The text that do-action takes: forms done one after another as one motion. A POINT is a learned variable or (X Y Z),
// mm in the base frame.
//
//   (move X Y Z)  (move POINT)    straight, the tool's direction kept
//   (track MM)                    the track there, the other axes as they are
//   (path VARIABLE ...)           joint moves through learned variables
//
//   (circle P1 P2 P3)             straight to P1, then the circle through P2 and P3 back to P1
//   (arc P1 P2 P3)                straight to P1, then the part of that circle up to P3
//
// Circles and arcs keep the tool's direction.
//
// Controller-script spelling is taken too, a command a line: `CIRCLE p1, p2, p3`. At most 4096 bytes, 32 forms.
// Failures: bad-action, unknown-variable, and those of the way itself (unreachable, joint-limit, too-long), each with
// its place in the text.

#include <string_view>

#include "agents/robot/motion.hpp"

namespace pizarra::robot {

Result<std::vector<arm::Joints>> script_waypoints(const arm::ArmModel& model, std::string_view text,
                                                  const arm::Joints& from, const ArmVariables& variables);

}  // namespace pizarra::robot
