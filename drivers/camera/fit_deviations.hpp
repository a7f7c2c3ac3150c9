#pragma once

// How well a calibration is known: what its fit leaves open, from how the corners would move if it were another. Boards
// that were hardly tilted fit many cameras, and leave no error behind that tells.
//
//   calibration.deviations = deviations_of(calibration, views);
//   if (calibration.deviations.focal_px > 0.03 * calibration.left.focal_x_px) ...   // more views, from more sides

#include <vector>

#include "drivers/camera/chessboard.hpp"

namespace pizarra::camera {

// Standard deviations, given the calibration's reprojection error; infinite where the views leave all open. Taking the
// same view several times makes the deviations smaller than they are.
CalibrationDeviations deviations_of(const StereoCalibration& calibration, const std::vector<BoardView>& views);

}  // namespace pizarra::camera
