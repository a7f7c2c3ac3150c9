#pragma once

// The calibration of a pair of cameras: their lenses, and how they stand to each other. A file that a person can read:
//
//   (calibration
//     (size 640 480)                                    ; of the images, px
//     (left (focal 536.1 536.2) (centre 342.3 235.6) (distortion -0.27 -0.04 0.001 0 0.24))    ; px; k1 k2 p1 p2 k3
//     (right (focal 539.2 539.1) (centre 328.1 248.5) (distortion -0.29 0.1 0 0 0))
//     (rotation 0.99 0 0.01 0 1 0 -0.01 0 0.99)         ; row by row, and in mm:
//     (translation -83.2 1.1 0.1)                       ; right = rotation left + translation
//     (board 9 6 25)                                    ; that it was made with: inner corners, mm
//     (errors 13 0.31 0.17)                             ; pairs; px: RMS of the corners, mean across the rectified rows
//     (deviations 0.5 0.8 0.07))                        ; standard, of focal length and centre, px, and base line, mm
//
// Of one camera alone there are (size ...), (lens (focal ...) (centre ...) (distortion ...)), (board ...),
// (errors 13 0.31), images and px, and (deviations 0.5 0.8). The deviations may be left out. Values that no lens has,
// such as a focal length of one pixel, are refused.
//
//   Result<StereoCalibration> calibration = read_calibration_file("pair.calibration");

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "lisp/result.hpp"

namespace pizarra::camera {

struct LensModel {
  double focal_x_px = 0;
  double focal_y_px = 0;
  double centre_x_px = 0;
  double centre_y_px = 0;
  std::array<double, 5> distortion{};
};

// The tags in the light squares of a ChArUco board.
struct BoardTags {
  std::string family = "aruco-4x4-50";
  int dictionary = 0;  // as OpenCV numbers that family
  double side_mm = 18;
};

struct CalibrationBoard {
  int columns = 9;  // of inner corners
  int rows = 6;
  double square_mm = 25;
  std::optional<BoardTags> tags = {};  // none: a chessboard
};

// How far what was fitted may be off, as standard deviations; of both cameras the larger one. 0: not said.
struct CalibrationDeviations {
  double focal_px = 0;
  double centre_px = 0;
  double base_line_mm = 0;
};

// Of one camera alone, `left` is its lens and the translation is none.
struct StereoCalibration {
  int width = 0;
  int height = 0;
  LensModel left;
  LensModel right;
  std::array<double, 9> rotation{1, 0, 0, 0, 1, 0, 0, 0, 1};
  std::array<double, 3> translation_mm{};
  CalibrationBoard board;
  int pairs = 0;
  double reprojection_px = 0;
  double epipolar_px = 0;
  CalibrationDeviations deviations = {};

  bool is_single() const { return translation_mm == std::array<double, 3>{}; }
};

// A failure reports every error of the file, each with a caret.
Result<StereoCalibration> read_calibration(std::string_view text, const std::string& file);
Result<StereoCalibration> read_calibration_file(const std::string& path);
// The text that read_calibration() reads.
std::string write_calibration(const StereoCalibration& calibration);

}  // namespace pizarra::camera
