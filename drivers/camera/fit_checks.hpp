#pragma once

// Whether what a fit found can be right, and is known well enough to be used.
//
//   const Fit<void> certain = check_deviations(calibration);
//   if (!certain) return std::unexpected(certain.error());

#include <string_view>

#include "drivers/camera/lens_fit.hpp"

namespace pizarra::camera {

// What a fit of `what` left, RMS.
struct FitErrors {
  std::string_view what;
  double error_px;
  const std::vector<double>& view_errors_px;
  const std::vector<BoardView>& views;
  int width_px;
};

// Likely causes of errors that are too large.
inline constexpr std::string_view lens_cause =
    "Are all images of one camera at one zoom, and is the board flat and whole in each?";
inline constexpr std::string_view pair_cause =
    "Do the images of each pair belong together? They are paired in the order of their names, and must be of one "
    "moment and at one zoom";

inline constexpr double least_tilts_deg = 15;
// By how much the two boards differ that are tilted most differently; `turns`: as OpenCV tells them.
double tilts_deg(const std::vector<cv::Mat>& turns);

OddView worst_of(const std::vector<BoardView>& views, const std::vector<double>& errors_px);

// Failures: no-solution, misfit.
Fit<void> check_errors(const FitErrors& fit, std::string_view cause);
// Failure: uncertain.
Fit<void> check_tilts(std::string_view what, const std::vector<cv::Mat>& turns);
// Failure: uncertain.
Fit<void> check_deviations(const StereoCalibration& calibration);
// That it is a pair side by side, and which is which; `at` is where the right camera sees the left one. Leaving views
// out changes nothing about it. Failures: one-camera, turned, swapped.
Fit<void> check_places(const cv::Vec3d& at);
// Failure: misfit.
Fit<void> check_rows(double rows_px, const OddView& worst);
// That neither stands before the other. Failure: misfit.
Fit<void> check_depths(const cv::Vec3d& at, const OddView& worst);

}  // namespace pizarra::camera
