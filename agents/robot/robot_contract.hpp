#pragma once

// The robot agent's contract: operations, facts, settings.

#include <string_view>

namespace pizarra::robot {

inline constexpr std::string_view robot_contract = R"scheme(
(contract robot
  (offers (get-status) (do-action (text string))
          (move-to (x number) (y number) (z number))
          (retract (mm number)) (extend (keep symbol) (mm number))
          (turn (direction symbol) (degrees number))
          (move-h (direction symbol) (mm number)) (move-v (direction symbol) (mm number))
          (turn-ef (direction symbol) (degrees number)) (turn-wrist (direction symbol) (degrees number))
          (home) (ready) (speed (percent number)) (learn (variable symbol)) (goto (variable symbol))
          (gripper (mm number)) (monitor) (finish (option symbol)) (finish (option symbol) (request symbol))
          (get-control) (release-control) (jog (direction symbol) (deadline number)))
  (posts (relation arm ((robot symbol) (state symbol) (action string)) (key robot))
         (relation arm-pose ((robot symbol) (x number) (y number) (z number) (rx number) (ry number) (rz number))
                   (key robot))
         (relation arm-foot ((robot symbol) (x number) (y number)) (key robot))
         (relation arm-joints ((robot symbol) (joints list)) (key robot))
         (relation gripper ((robot symbol) (opening number)) (key robot))
         (relation gripped ((robot symbol) (whether symbol)) (key robot))
         (relation robot-variable ((robot symbol) (name symbol) (joints list)) (key robot name) (durable))
         (relation robot-speed ((robot symbol) (percent number)) (key robot) (durable))
         (relation robot-released ((robot symbol) (client symbol)) (key robot) (durable))
         (relation property ((agent symbol) (name symbol) (value datum)) (key agent name) (durable))
         (relation robot-motion ((robot symbol) (request symbol) (outcome list)) (key robot) (durable)))
  (reads (relation stop ((who symbol) (reason string)) (key who) (durable))
         (relation commander ((robot symbol) (client symbol)) (key robot client))
         (relation hold ((robot symbol) (client symbol) (count integer)) (key robot client))
         robot-variable robot-speed robot-motion robot-released agent)
  (configures speed learn)
  (monitors get-status monitor finish))
)scheme";

}  // namespace pizarra::robot
