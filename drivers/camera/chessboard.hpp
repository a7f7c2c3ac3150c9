#pragma once

// Calibrates a pair of cameras, or one, by a chessboard or a ChArUco board that all see from several sides. One camera
// is a pair without a right image.
//
//   std::vector<BoardView> views;
//   Result<BoardView> view = find_board(left, right, board);         // for each pair of images
//   Result<CalibratedPair> pair = calibrate_pair(views, left.size(), board);
//
// A few views whose images do not belong together are left out, and named in what is found.
//
// Failures: no-board, saying in which image; too-few; swapped, where the right camera stands left of the left one;
// turned, where it stands above or below it; one-camera, where it stands at the same place; no-solution; misfit, where
// what was found cannot be right, as the images do not belong together, and those that are farthest off are not to
// blame alone; uncertain, where other cameras would see the boards nearly the same.

#include <functional>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "drivers/camera/calibration.hpp"

namespace pizarra::camera {

// The board's inner corners in both images, in the same order, px.
struct BoardView {
  std::vector<cv::Point2f> left = {};
  std::vector<cv::Point2f> right = {};
  std::string name = {};                // as a person knows it
  std::vector<std::size_t> which = {};  // which of the board's corners they are; empty: all, row by row
};

// RMS of a view's corners in both images, px.
struct ViewError {
  std::string name;
  double px = 0;
};

// Where they are on the board, row by row, mm.
std::vector<cv::Point3f> corners_of(const CalibrationBoard& board);
// Those that the view has, in its order.
std::vector<cv::Point3f> corners_of(const BoardView& view, const CalibrationBoard& board);

// 8 bit images, grey or BGR, of one size; the right one is empty where one camera is alone.
Result<BoardView> find_board(const cv::Mat& left, const cv::Mat& right, const CalibrationBoard& board);

inline constexpr std::size_t least_views = 5;

struct CalibratedPair {
  StereoCalibration calibration;
  ViewError worst;                  // of the views that it was made of
  std::vector<ViewError> left_out;  // would have spoilt all
};

// Hears what is done next, for each may take seconds.
using TellStep = std::function<void(const std::string&)>;

// Views of the same place are taken for as many.
Result<CalibratedPair> calibrate_pair(
    const std::vector<BoardView>& views, cv::Size image, const CalibrationBoard& board,
    const TellStep& tell = [](const std::string&) {});
// Of views with corners in the left image alone, one camera's lens.
Result<CalibratedPair> calibrate_single(
    const std::vector<BoardView>& views, cv::Size image, const CalibrationBoard& board,
    const TellStep& tell = [](const std::string&) {});

// How far apart in height the same corner lies in both images once rectified: mean of the views, px.
double epipolar_error_px(const StereoCalibration& calibration, const std::vector<BoardView>& views);

}  // namespace pizarra::camera
