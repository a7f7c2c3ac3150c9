#include "drivers/camera/chessboard.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

#include "drivers/camera/stereo_geometry.hpp"

namespace pizarra {
namespace {

// Few boards near the corners say little about what k3 does there.
constexpr int lens_flags = cv::CALIB_FIX_K3;

std::vector<cv::Point2f> find_corners(const cv::Mat& image, const CalibrationBoard& board) {
  cv::Mat grey = image;
  if (image.channels() == 3) cv::cvtColor(image, grey, cv::COLOR_BGR2GRAY);
  const cv::Size pattern(board.columns, board.rows);
  std::vector<cv::Point2f> corners;
  if (cv::findChessboardCorners(grey, pattern, corners, cv::CALIB_CB_ADAPTIVE_THRESH | cv::CALIB_CB_NORMALIZE_IMAGE)) {
    // No further than half a square: next to it lies another corner.
    const double square_px = cv::norm(corners[1] - corners[0]);
    const int reach = std::clamp(cvRound(square_px / 2.5), 2, 11);
    cv::cornerSubPix(grey, corners, {reach, reach}, {-1, -1},
                     {cv::TermCriteria::COUNT | cv::TermCriteria::EPS, 100, 0.001});
    return corners;
  }
  if (!cv::findChessboardCornersSB(grey, pattern, corners)) corners.clear();
  return corners;
}

// A board looks the same from below: of both orders the right image's is the one that runs the left image's way.
void order_alike(const std::vector<cv::Point2f>& left, std::vector<cv::Point2f>& right) {
  if ((left.back() - left.front()).dot(right.back() - right.front()) < 0) std::reverse(right.begin(), right.end());
}

std::vector<cv::Point3f> corners_of(const CalibrationBoard& board) {
  std::vector<cv::Point3f> out;
  for (int y = 0; y < board.rows; ++y) {
    for (int x = 0; x < board.columns; ++x) {
      out.emplace_back(static_cast<float>(x * board.square_mm), static_cast<float>(y * board.square_mm), 0.F);
    }
  }
  return out;
}

struct Lens {
  cv::Matx33d camera = cv::Matx33d::eye();
  cv::Mat distortion;
};

LensModel model_of(const Lens& lens) {
  LensModel out{lens.camera(0, 0), lens.camera(1, 1), lens.camera(0, 2), lens.camera(1, 2), {}};
  for (int i = 0; i < 5; ++i) out.distortion[static_cast<std::size_t>(i)] = lens.distortion.at<double>(i);
  return out;
}

Result<CalibratedPair> calibrate_single(const std::vector<BoardView>& views, cv::Size image,
                                        const CalibrationBoard& board) {
  const std::vector<std::vector<cv::Point3f>> boards(views.size(), corners_of(board));
  std::vector<std::vector<cv::Point2f>> corners;
  for (const BoardView& view : views) corners.push_back(view.left);
  Lens lens;
  std::vector<cv::Mat> unused;
  std::vector<double> view_errors;
  double error = 0;
  try {
    error = cv::calibrateCamera(boards, corners, image, lens.camera, lens.distortion, unused, unused, cv::noArray(),
                                cv::noArray(), view_errors, lens_flags);
  } catch (const cv::Exception&) {
    error = NAN;
  }
  if (!std::isfinite(error)) return fail("no-solution", "no camera sees the boards like that");
  CalibratedPair out;
  out.calibration = {.width = image.width,
                     .height = image.height,
                     .left = model_of(lens),
                     .right = {},
                     .board = board,
                     .pairs = static_cast<int>(views.size()),
                     .reprojection_px = error};
  out.view_errors_px = std::move(view_errors);
  return out;
}

}  // namespace

Result<BoardView> find_board(const cv::Mat& left, const cv::Mat& right, const CalibrationBoard& board) {
  BoardView view{find_corners(left, board), {}};
  const bool in_left = !view.left.empty();
  if (right.empty() && !in_left) {
    return fail("no-board", fmt::format("no board of {} x {} inner corners", board.columns, board.rows));
  }
  if (right.empty()) return view;
  view.right = find_corners(right, board);
  const bool in_right = !view.right.empty();
  if (!in_left || !in_right) {
    return fail("no-board", fmt::format("no board of {} x {} inner corners in {}", board.columns, board.rows,
                                        in_left    ? "the right image"
                                        : in_right ? "the left image"
                                                   : "either image"));
  }
  order_alike(view.left, view.right);
  return view;
}

Result<CalibratedPair> calibrate_pair(const std::vector<BoardView>& views, cv::Size image,
                                      const CalibrationBoard& board) {
  const bool single = !views.empty() && views.front().right.empty();
  if (views.size() < least_views) {
    return fail("too-few", fmt::format("a calibration takes at least {} {} in which the board is found, from "
                                       "different sides; there are {}",
                                       least_views, single ? "images" : "pairs", views.size()));
  }
  if (single) return calibrate_single(views, image, board);
  const std::vector<std::vector<cv::Point3f>> boards(views.size(), corners_of(board));
  std::vector<std::vector<cv::Point2f>> left;
  std::vector<std::vector<cv::Point2f>> right;
  for (const BoardView& view : views) {
    left.push_back(view.left);
    right.push_back(view.right);
  }
  Lens lenses[2];
  cv::Mat rotation;
  cv::Mat translation;
  cv::Mat unused;
  cv::Mat view_errors;
  double error = 0;
  try {
    cv::calibrateCamera(boards, left, image, lenses[0].camera, lenses[0].distortion, cv::noArray(), cv::noArray(),
                        lens_flags);
    cv::calibrateCamera(boards, right, image, lenses[1].camera, lenses[1].distortion, cv::noArray(), cv::noArray(),
                        lens_flags);
    error = cv::stereoCalibrate(boards, left, right, lenses[0].camera, lenses[0].distortion, lenses[1].camera,
                                lenses[1].distortion, image, rotation, translation, unused, unused, view_errors,
                                lens_flags | cv::CALIB_USE_INTRINSIC_GUESS);
  } catch (const cv::Exception&) {
    error = NAN;
  }
  if (!std::isfinite(error)) return fail("no-solution", "no pair of cameras sees the boards like that");
  CalibratedPair out;
  StereoCalibration& calibration = out.calibration;
  calibration = {.width = image.width,
                 .height = image.height,
                 .left = model_of(lenses[0]),
                 .right = model_of(lenses[1]),
                 .board = board,
                 .pairs = static_cast<int>(views.size()),
                 .reprojection_px = error};
  std::copy_n(rotation.ptr<double>(), 9, calibration.rotation.begin());
  std::copy_n(translation.ptr<double>(), 3, calibration.translation_mm.begin());
  if (calibration.translation_mm[0] > -1) {
    return fail("swapped", "the right camera stands to the left of the left one: give the images the other way round");
  }
  for (int i = 0; i < view_errors.rows; ++i) {
    out.view_errors_px.push_back(std::hypot(view_errors.at<double>(i, 0), view_errors.at<double>(i, 1)) / std::sqrt(2));
  }
  calibration.epipolar_px = epipolar_error_px(calibration, views);
  return out;
}

double epipolar_error_px(const StereoCalibration& calibration, const std::vector<BoardView>& views) {
  const StereoGeometry geometry(calibration);
  double sum = 0;
  std::size_t count = 0;
  for (const BoardView& view : views) {
    for (std::size_t i = 0; i < view.left.size(); ++i) {
      const cv::Point2d left = geometry.rectified(view.left[i], StereoGeometry::Side::left);
      const cv::Point2d right = geometry.rectified(view.right[i], StereoGeometry::Side::right);
      sum += std::abs(left.y - right.y);
      ++count;
    }
  }
  return count == 0 ? 0 : sum / static_cast<double>(count);
}

}  // namespace pizarra
