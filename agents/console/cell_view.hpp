#pragma once

// What is known of the cell from its file: nothing of it is on the board.

#include <map>
#include <optional>
#include <string>

#include "agents/console/reach_outline.hpp"
#include "lisp/forms/camera_pose.hpp"

namespace pizarra::console {

struct CellView {
  std::string name;
  std::map<std::string, arm::ArmModel> arms;         // by their agents' names
  std::optional<forms::CameraPose> camera;           // in the base frame
  bool head = false;                                 // a unit turns it from there, and tells by how much
  double cube_mm = 60;                               // the length of what is drawn as a cube
  std::map<std::string, ReachOutline> reaches = {};  // of these arms, at the height of a cube's middle
};

}  // namespace pizarra::console
