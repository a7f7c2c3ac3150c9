#pragma once

// What the robot agent offers, posts, reads, lets you configure and monitor.

#include <string_view>

namespace pizarra {

inline constexpr std::string_view robot_contract = R"scheme(
(contract robot
  (offers (get-status) (do-action (text string))
          (retract (mm number)) (extend (keep symbol) (mm number))
          (turn (direction symbol) (degrees number))
          (move-h (direction symbol) (mm number)) (move-v (direction symbol) (mm number))
          (turn-ef (direction symbol) (degrees number)) (turn-wrist (direction symbol) (degrees number))
          (home) (ready) (speed (percent number)) (learn (variable symbol)) (goto (variable symbol))
          (gripper (mm number)) (monitor) (finish (option symbol)))
  (posts (relation arm ((state symbol) (action string)) (key))
         (relation arm-pose ((x number) (y number) (z number) (rx number) (ry number) (rz number)) (key))
         (relation arm-joints ((joints list)) (key))
         (relation gripper ((opening number)) (key))
         (relation stop ((who symbol) (reason string)) (key who))
         (relation commander ((robot symbol) (client symbol)) (key robot client))
         (relation robot-variable ((name symbol) (joints list)) (key name) (durable))
         (relation robot-speed ((percent number)) (key) (durable))
         (relation robot-move ((operation list) (start list)) (key) (durable)))
  (reads robot-variable robot-speed robot-move stop commander agent)
  (configures speed learn)
  (monitors get-status monitor finish))
)scheme";

}  // namespace pizarra
