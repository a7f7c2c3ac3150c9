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
// Of the image's width: no blur leaves corners so far off, but images that do not belong together do.
constexpr double most_error = 0.005;

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
  double error_px = 0;  // RMS
  std::vector<double> view_errors_px;
};

LensModel model_of(const Lens& lens) {
  LensModel out{lens.camera(0, 0), lens.camera(1, 1), lens.camera(0, 2), lens.camera(1, 2), {}};
  for (int i = 0; i < 5; ++i) out.distortion[static_cast<std::size_t>(i)] = lens.distortion.at<double>(i);
  return out;
}

using Corners = std::vector<std::vector<cv::Point2f>>;  // of each view
using Boards = std::vector<std::vector<cv::Point3f>>;

// Whether what was found for `what` can be right.
Result<void> check_errors(std::string_view what, double error_px, const std::vector<double>& view_errors_px,
                          cv::Size image, std::string_view cause) {
  if (!std::isfinite(error_px)) return fail("no-solution", fmt::format("no {} sees the boards like that", what));
  const double most_px = most_error * image.width;
  if (error_px <= most_px) return {};
  const auto worst = std::ranges::max_element(view_errors_px);
  return fail(
      "misfit",
      fmt::format("no {} sees the boards like that: the nearest leaves a reprojection error of {:.1f} px, where "
                  "{:.1f} is too much already; of the boards found, number {} is farthest off, {:.1f} px. {}",
                  what, error_px, most_px, worst - view_errors_px.begin() + 1, *worst, cause));
}

Result<Lens> calibrate_lens(std::string_view what, const Boards& boards, const Corners& corners, cv::Size image) {
  Lens out;
  std::vector<cv::Mat> unused;
  try {
    out.error_px = cv::calibrateCamera(boards, corners, image, out.camera, out.distortion, unused, unused,
                                       cv::noArray(), cv::noArray(), out.view_errors_px, lens_flags);
  } catch (const cv::Exception&) {
    out.error_px = NAN;
  }
  const Result<void> checked =
      check_errors(what, out.error_px, out.view_errors_px, image,
                   "Are all images of one camera at one zoom, and is the board flat and whole in each?");
  if (!checked) return fail(checked);
  return out;
}

Result<CalibratedPair> calibrate_single(const Boards& boards, const Corners& corners, cv::Size image,
                                        const CalibrationBoard& board) {
  Result<Lens> lens = calibrate_lens("camera", boards, corners, image);
  if (!lens) return fail(lens);
  CalibratedPair out;
  out.calibration = {.width = image.width,
                     .height = image.height,
                     .left = model_of(*lens),
                     .right = {},
                     .board = board,
                     .pairs = static_cast<int>(boards.size()),
                     .reprojection_px = lens->error_px};
  out.view_errors_px = std::move(lens->view_errors_px);
  return out;
}

// Where the right camera is, seen from the left one; the lenses become what suits both.
struct Arrangement {
  cv::Mat rotation;
  cv::Mat translation;
  double error_px = 0;  // RMS
  std::vector<double> view_errors_px;
};

Result<Arrangement> arrange(const Boards& boards, const Corners& left, const Corners& right, cv::Size image,
                            Lens& left_lens, Lens& right_lens) {
  Arrangement out;
  cv::Mat unused;
  cv::Mat errors;
  try {
    out.error_px = cv::stereoCalibrate(boards, left, right, left_lens.camera, left_lens.distortion, right_lens.camera,
                                       right_lens.distortion, image, out.rotation, out.translation, unused, unused,
                                       errors, lens_flags | cv::CALIB_USE_INTRINSIC_GUESS);
  } catch (const cv::Exception&) {
    out.error_px = NAN;
  }
  for (int i = 0; i < errors.rows; ++i) {
    out.view_errors_px.push_back(std::hypot(errors.at<double>(i, 0), errors.at<double>(i, 1)) / std::sqrt(2));
  }
  const Result<void> checked = check_errors(
      "pair of cameras", out.error_px, out.view_errors_px, image,
      "Do the images of each pair belong together? They are paired in the order of their names, and must be "
      "of one moment");
  if (!checked) return fail(checked);
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
  const Boards boards(views.size(), corners_of(board));
  Corners left;
  Corners right;
  for (const BoardView& view : views) {
    left.push_back(view.left);
    right.push_back(view.right);
  }
  if (single) return calibrate_single(boards, left, image, board);
  Result<Lens> left_lens = calibrate_lens("left camera", boards, left, image);
  if (!left_lens) return fail(left_lens);
  Result<Lens> right_lens = calibrate_lens("right camera", boards, right, image);
  if (!right_lens) return fail(right_lens);
  Result<Arrangement> found = arrange(boards, left, right, image, *left_lens, *right_lens);
  if (!found) return fail(found);
  CalibratedPair out;
  StereoCalibration& calibration = out.calibration;
  calibration = {.width = image.width,
                 .height = image.height,
                 .left = model_of(*left_lens),
                 .right = model_of(*right_lens),
                 .board = board,
                 .pairs = static_cast<int>(views.size()),
                 .reprojection_px = found->error_px};
  std::copy_n(found->rotation.ptr<double>(), 9, calibration.rotation.begin());
  std::copy_n(found->translation.ptr<double>(), 3, calibration.translation_mm.begin());
  if (calibration.translation_mm[0] > -1) {
    return fail("swapped", "the right camera stands to the left of the left one: give the images the other way round");
  }
  out.view_errors_px = std::move(found->view_errors_px);
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
