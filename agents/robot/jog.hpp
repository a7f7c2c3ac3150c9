#pragma once

// The motion of a held jog, from where the arm stands: on and on in one direction, until it is let go (holds.hpp) or
// the arm reaches no further. Pure, as plan_motion() is.
//
//   const Result<Motion> way = plan_jog(model, room, "left", joints);
//   const double part = jog_speed(model, joints, way->waypoints, 250ms);
//
// Directions: left, right, up, down (straight along the base's axes), out, in (as extend and retract), turn-left,
// turn-right, tool-up, tool-down, wrist-left, wrist-right. Failures: wrong-direction, and those of plan_motion().

#include <optional>
#include <string_view>

#include "agents/robot/motion.hpp"
#include "blackboard/time/clock.hpp"

namespace pizarra::robot {

// How far the grip centre goes, and the tool turns, at most from the last sign of the hand to where the arm stands.
inline constexpr double jog_overrun_mm = 10;
inline constexpr double jog_overrun_deg = 10;
// The time to notice the silence, to stop and to brake.
inline constexpr Duration jog_stopping = 100ms;

Result<Motion> plan_jog(const arm::ArmModel& model, const std::optional<WorkVolume>& room, std::string_view direction,
                        const arm::Joints& from);

// The part of the axes' speeds, above 0 and at most 1, at which an arm that is stopped `deadline` after the last sign
// of the hand stands within the overrun.
double jog_speed(const arm::ArmModel& model, const arm::Joints& from, const std::vector<arm::Joints>& waypoints,
                 Duration deadline);

}  // namespace pizarra::robot
