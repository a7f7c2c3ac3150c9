#pragma once

// Draws a head under the cameras of a run, and the agents' guess of where these stand, as a person makes one with a
// rule. The cell is to find out by itself, from the gripper's mark, where the camera stands.
//
//   draw_head(cell, random.split("head"));
//   guess_camera(cell, random.split("camera"));
//   const std::string line = describe_camera(cell);      // where it stands, and where it is taken to stand

#include <string>

#include "blackboard/time/random.hpp"
#include "lisp/forms/cell_file.hpp"

namespace pizarra::chaos {

// Whether the agents take it to stand elsewhere than it does.
bool is_camera_guessed(const forms::CellDescription& cell);
// Off by 20 mm and by 2 degrees, each in a direction that is drawn. A cell whose own file is surer keeps that.
void guess_camera(forms::CellDescription& cell, Random random);
// One cell in eight has its cameras on a pan-tilt unit. A cell whose own file has one keeps that.
void draw_head(forms::CellDescription& cell, Random random);
// Of 640x480, where the cell has smaller ones.
void take_larger_images(forms::CellDescription& cell);
std::string describe_camera(const forms::CellDescription& cell);

}  // namespace pizarra::chaos
