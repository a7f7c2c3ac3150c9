#pragma once

// The lenses of the simulated cameras bend their images. A calibration says how, as one of real cameras does.
//
//   const std::optional<Eigen::Vector2d> straight = undistorted(distortion, {0.3, -0.2});
//   const camera::StereoGeometry geometry(calibration_of(config.camera));

#include <Eigen/Core>
#include <optional>

#include "drivers/camera/calibration.hpp"
#include "drivers/simulation/world_config.hpp"

namespace pizarra::simulation {

// Where a pinhole camera sees what the lens shows there, both in focal lengths from the middle. None where the lens
// shows nothing, or the same point twice.
std::optional<Eigen::Vector2d> undistorted(const LensDistortion& lens, const Eigen::Vector2d& point);

// Whether every place of its images shows another point, none much further out than a pinhole camera would show there.
bool shows_all_once(const CameraConfig& camera);

// Exact: both lenses are alike and look the same way.
camera::StereoCalibration calibration_of(const CameraConfig& camera);

}  // namespace pizarra::simulation
