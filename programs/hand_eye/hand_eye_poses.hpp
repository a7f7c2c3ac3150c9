#pragma once

// The poses to which an arm carries its mark, so that what the camera sees of it tells where the camera stands: within
// the arm's reach and the camera's view, far apart from one another, and with the tool turned in different ways, which
// alone tells where the mark is on the tool.
//
//   for (const CarriedPose& pose : poses_to_carry_to(arm, view, mark_mm, area, 24)) ...

#include <vector>

#include "agents/coordinator/geometry/camera_view.hpp"
#include "drivers/arm/kinematics.hpp"
#include "drivers/ptu/pan_tilt_driver.hpp"

namespace pizarra::hand_eye {

struct CarriedPose {
  Eigen::Vector3d grip_mm;
  double yaw_deg = 0;   // of the tool that points down, as the robot's rz tells it
  double tilt_deg = 0;  // of the tool, upwards
};

// Of the grip, mm.
struct CarryingRoom {
  Eigen::Vector3d low_mm;
  Eigen::Vector3d high_mm;
};

// At most `wanted`, in an order in which neighbours are near each other. `margin_mm`: how far a mark must be from the
// edge of the view, since nobody knows yet where that is. Empty where no pose is in view and within reach.
std::vector<CarriedPose> poses_to_carry_to(const arm::ArmModel& arm, const coordinator::CameraView& view,
                                           const Eigen::Vector3d& mark_mm, const CarryingRoom& room, double margin_mm,
                                           std::size_t wanted);

// The angles to which a pan-tilt unit turns its camera, so that what is seen from there of a mark that stands still
// tells about which axes it turned: far apart, and with the mark in both images.
// At most `wanted`; the middle is none of them. `mark_mm` in the base frame, `margin_mm` as above.
std::vector<ptu::HeadTurn> angles_to_turn_to(const forms::CameraPose& pose, const coordinator::CameraModel& model,
                                             const Eigen::Vector3d& mark_mm, const ptu::PanTiltRange& range,
                                             double margin_mm, std::size_t wanted);

}  // namespace pizarra::hand_eye
