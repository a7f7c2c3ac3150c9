#pragma once

// The angles to which a pan-tilt unit turns its camera, so that what is seen from there of a mark that stands still
// tells about which axes it turned: far apart, and with the mark in both images.
//
//   for (const HeadTurn turn : angles_to_turn_to(guess.pose, model, mark_mm, range, margin_mm, 6)) ...

#include <vector>

#include "agents/coordinator/geometry/camera_view.hpp"
#include "drivers/ptu/pan_tilt_driver.hpp"

namespace pizarra::hand_eye {

// At most `wanted`; the middle is none of them. `mark_mm` in the base frame. `margin_mm`: how far the mark must be from
// the edge of the view, since nobody knows yet where that is.
std::vector<ptu::HeadTurn> angles_to_turn_to(const forms::CameraPose& pose, const coordinator::CameraModel& model,
                                             const Eigen::Vector3d& mark_mm, const ptu::PanTiltRange& range,
                                             double margin_mm, std::size_t wanted);

}  // namespace pizarra::hand_eye
