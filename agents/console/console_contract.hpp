#pragma once

// The relations that a page reads and posts, as parts of its contract.
//
//   contract_from_text(fmt::format("(contract console {} {})", posts_of_pages, reads_of_pages));

namespace pizarra::console {

// The robot's agent declares most of these relations; a page declares those that it needs before the robot is there.
inline constexpr const char* posts_of_pages = "(posts commander commander-wanted hold stop)";

inline constexpr const char* reads_of_pages =
    "(reads agent arm arm-joints arm-pose believed board-refusal calibration calibration-board calibration-lacks "
    "calibration-sees camera-model camera-pose camera-state commander commander-wanted context-board contract event "
    "found goal goal-state gripper head head-speed holder learned learned-template look look-alike micro-task "
    "operation pan-tilt place plan plan-needs process provenance request robot-released robot-speed robot-variable "
    "servo stop stream tracked vision-held vision-mode)";

}  // namespace pizarra::console
