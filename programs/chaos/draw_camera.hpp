#pragma once

// Where the agents of a run take the camera to stand: a guess, such as a person makes with a rule. The cell is to find
// out by itself, from the gripper's mark, where the camera stands.
//
//   guess_camera(cell, random.split("camera"));
//   const std::string line = describe_camera(cell);      // where it stands, and where it is taken to stand

#include <string>

#include "blackboard/time/random.hpp"
#include "lisp/forms/cell_file.hpp"

namespace pizarra::chaos {

// Whether the agents take it to stand elsewhere than it does.
bool is_camera_guessed(const forms::CellDescription& cell);
// Off by 20 mm and by 2 degrees, each in a direction that is drawn. A cell whose own file has a guess keeps that.
void guess_camera(forms::CellDescription& cell, Random random);
std::string describe_camera(const forms::CellDescription& cell);

}  // namespace pizarra::chaos
