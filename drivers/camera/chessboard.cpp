#include "drivers/camera/chessboard.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

#include "drivers/camera/charuco.hpp"
#include "drivers/camera/lens_fit.hpp"
#include "drivers/camera/stereo_geometry.hpp"

namespace pizarra::camera {
namespace {

// More pairs than a quarter that do not belong are no slip, and each that is left out takes a calibration more.
constexpr std::size_t pairs_to_one_left_out = 4;
constexpr std::size_t most_left_out = 5;

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

using FitViews = Fit<CalibratedPair>(const std::vector<BoardView>&, cv::Size, const CalibrationBoard&, const TellStep&);

// Views that spoil the others are left out one by one.
Result<CalibratedPair> calibrate(const std::vector<BoardView>& views, cv::Size image, const CalibrationBoard& board,
                                 const TellStep& tell, FitViews& fit) {
  const std::size_t most_odd =
      std::min({most_left_out, views.size() / pairs_to_one_left_out, views.size() - least_views});
  const Fit<CalibratedPair> of_all = fit(views, image, board, tell);
  Fit<CalibratedPair> found = of_all;
  std::vector<BoardView> kept = views;
  std::vector<ViewError> left_out;
  while (!found && found.error().worst && left_out.size() < most_odd) {
    const OddView odd = *found.error().worst;
    kept.erase(kept.begin() + static_cast<std::ptrdiff_t>(odd.index));
    left_out.push_back(odd.error);
    tell(fmt::format("once more without {}", odd.error.name));
    found = fit(kept, image, board, tell);
  }
  if (found) {
    found->left_out = std::move(left_out);
    return std::move(*found);
  }
  // An error that is no smaller without some views is told of all views.
  return fail(found.error().worst ? of_all.error().why : found.error().why);
}

Result<void> check_count(std::size_t count, std::string_view of_what) {
  if (count >= least_views) return {};
  return fail("too-few", fmt::format("a calibration takes at least {} {} in which the board is found, each at another "
                                     "place and angle; there are {}",
                                     least_views, of_what, count));
}

}  // namespace

std::vector<cv::Point3f> corners_of(const CalibrationBoard& board) {
  std::vector<cv::Point3f> out;
  for (int y = 0; y < board.rows; ++y) {
    for (int x = 0; x < board.columns; ++x) {
      out.emplace_back(static_cast<float>(x * board.square_mm), static_cast<float>(y * board.square_mm), 0.F);
    }
  }
  return out;
}

std::vector<cv::Point3f> corners_of(const BoardView& view, const CalibrationBoard& board) {
  std::vector<cv::Point3f> all = corners_of(board);
  if (view.which.empty()) return all;
  std::vector<cv::Point3f> out;
  for (const std::size_t corner : view.which) out.push_back(all[corner]);
  return out;
}

Result<BoardView> find_board(const cv::Mat& left, const cv::Mat& right, const CalibrationBoard& board) {
  if (board.tags) return find_charuco(left, right, board);
  BoardView view{.left = find_corners(left, board)};
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
                                      const CalibrationBoard& board, const TellStep& tell) {
  const Result<void> counted = check_count(views.size(), "pairs");
  return counted ? calibrate(views, image, board, tell, fit_pair) : fail(counted);
}

Result<CalibratedPair> calibrate_single(const std::vector<BoardView>& views, cv::Size image,
                                        const CalibrationBoard& board, const TellStep& tell) {
  const Result<void> counted = check_count(views.size(), "images");
  return counted ? calibrate(views, image, board, tell, fit_single) : fail(counted);
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

}  // namespace pizarra::camera
