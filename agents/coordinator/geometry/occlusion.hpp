#pragma once

// What the gripper itself hides from the camera. A mark behind it is not lost: nothing is known of it until the gripper
// has moved on.

#include "agents/coordinator/geometry/camera_view.hpp"

namespace pizarra::coordinator {

// The gripper as the camera sees it, around the point where the mark of a held object would stand. Lengths mm.
struct GripperOutline {
  double half_width_mm = 62;  // of the palm
  double below_mm = 32;       // fingertips, or what is held
  double mark_half_mm = 24;   // an object's mark that is partly covered is not recognised either
};

// Whether a mark at `mark` stands behind the gripper at `grip`, both base frame.
bool hidden_by_gripper(const CameraView& view, const GripperOutline& outline, const Eigen::Vector3d& grip,
                       const Eigen::Vector3d& mark);

}  // namespace pizarra::coordinator
