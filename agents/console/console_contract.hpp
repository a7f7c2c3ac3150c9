#pragma once

// The relations that a page reads, as a part of its contract.

namespace pizarra::console {

inline constexpr const char* reads_of_pages =
    "(reads agent arm arm-joints arm-pose believed board-refusal calibration calibration-board calibration-lacks "
    "calibration-sees camera-model camera-pose camera-state commander commander-wanted context-board contract event "
    "found goal goal-state gripper head head-speed holder learned learned-template look look-alike micro-task operation "
    "pan-tilt place plan plan-needs process request robot-released robot-speed robot-variable servo stop stream tracked "
    "vision-held vision-mode)";

}  // namespace pizarra::console
