#pragma once

// The meaning of a motion operation for an arm at its present place: the waypoints to follow, or why not. Pure: the
// same arm, place and variables give the same motion.
//
// Extend and retract move in the plane that axis 1 turns. Move-h and move-v go along the base's y and z, to which a
// track may help. These, and the turns, are clamped to what the arm can reach, however much is asked for; only a line
// that the arm cannot be kept on is refused. All but the turns keep the tool's direction: the end-effector axis takes
// back what the links turn (CRS-F3: dj5 = -(dj2 + dj3), UP6: dB = dL - dU), unless the arm does that itself. With the
// tool down, (turn-wrist left D) takes back what (turn right D) turned the fingers by. An arm that no axis turns, as a
// gantry, carries its tool round the base instead, where a turn would.
//
// Failures: no-such-axis, out-of-range (an amount below 0), wrong-direction, unknown-variable, singular (the line
// cannot be kept to), and of places that are named (goto, move-to, do-action): unreachable, joint-limit, bad-action,
// too-long.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "agents/robot/work_volume.hpp"
#include "blackboard/time/clock.hpp"
#include "drivers/arm/kinematics.hpp"

namespace pizarra::robot {

using ArmVariables = std::map<std::string, arm::Joints, std::less<>>;

struct Motion {
  std::vector<arm::Joints> waypoints;  // none: there is nothing to move
  bool at_limit = false;               // because the arm is fully extended, contracted or turned already
};

// Whether the operation moves the arm: what plan_motion takes.
bool is_motion(const Datum& operation);

// `operation` has been checked against the contract.
Result<Motion> plan_motion(const arm::ArmModel& model, const Datum& operation, const arm::Joints& from,
                           const ArmVariables& variables);

// Whether the waypoints stay in the arm's room once they are in it. Failure `out-of-room`: the subject is where not.
Result<void> check_room(const arm::ArmModel& model, const std::optional<WorkVolume>& room, const arm::Joints& from,
                        const std::vector<arm::Joints>& waypoints);

// After which a motion through the waypoints has gone wrong: three times what the axes need, for their acceleration,
// and some seconds for the controller.
Duration longest_time(const arm::ArmModel& model, const arm::Joints& from, const std::vector<arm::Joints>& waypoints,
                      double speed);

// The joints of a learned variable; the failure names the nearest.
Result<arm::Joints> find_variable(const ArmVariables& variables, std::string_view name);

// A number given by a caller: at least `low`, at most `high`.
Result<double> amount_in(const Datum& given, double low, double high, std::string_view unit);

// A distance or an angle given by a caller: at least 0, and `high` where it is more.
Result<double> clamped_amount(const Datum& given, double high, std::string_view unit);

}  // namespace pizarra::robot
