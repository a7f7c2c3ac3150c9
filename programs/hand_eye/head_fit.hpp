#pragma once

// Where the camera on a pan-tilt unit stands, and about which axes the unit turns it, solved together from looks at the
// gripper's mark with the head in its middle and turned.
//
//   const HeadFit fit = fit_head({pose, mark_mm}, pairs, model);
//   fit.camera.pose.axes;           // in the camera's frame: lisp/forms/camera_pose.hpp

#include "agents/coordinator/geometry/camera_pose.hpp"

namespace pizarra::hand_eye {

struct HeadFit {
  coordinator::MountedCamera camera;
  // The largest standard deviations of the camera's place and direction, and of its axes'.
  double camera_mm, camera_deg;
  double axes_mm, axes_deg;
  double error_px;  // root mean square over the pairs, each coordinate
};

// The guess may be far off; without axes it is taken to stand on a unit whose axes meet in the camera.
HeadFit fit_head(const coordinator::MountedCamera& guess, std::span<const coordinator::MarkPair> pairs,
                 const coordinator::CameraModel& model);

}  // namespace pizarra::hand_eye
