#pragma once

// The gripper's shapes in the tool frame (drivers/arm/kinematics.hpp): z the approach, y closing, origin the grip
// centre, x towards the camera where the tool is down and its wrist turned back. Physics and picture share them.
//
//   const Eigen::Vector3d mark_mm = tool * gripper_shape::mark;

#include <Eigen/Core>

namespace pizarra::simulation {

struct Box {
  Eigen::Vector3d centre_mm;
  Eigen::Vector3d half_mm;
};

namespace gripper_shape {
inline constexpr double finger_thickness_mm = 8;
// A finger at y = 0; it reaches 20 beyond the grip centre.
inline const Box finger{{0, 0, -32}, {12, finger_thickness_mm / 2, 52}};
inline const Box palm{{0, 0, -107}, {20, 62, 23}};
// Its front lies in the plane of a held cube's front.
inline const Box plate{{28, 0, -68}, {2, 29, 28}};
// Centroid of the plate's white triangle.
inline const Eigen::Vector3d mark{30, 0, -66};
}  // namespace gripper_shape

}  // namespace pizarra::simulation
