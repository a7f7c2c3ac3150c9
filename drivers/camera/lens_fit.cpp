#include "drivers/camera/lens_fit.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <opencv2/calib3d.hpp>

#include "drivers/camera/stereo_geometry.hpp"

namespace pizarra {
namespace {

// Few boards near the corners say little about what k3 does there.
constexpr int lens_flags = cv::CALIB_FIX_K3;
// Of the image's width: no blur leaves corners so far off, but images that do not belong together do.
constexpr double most_error = 0.0025;
// A view is no part of the rest that is so many times farther off than the middle one, and so far, of the width: what
// is exact in all other views leaves a little anywhere.
constexpr double most_times_middle = 4;
constexpr double least_odd_error = 0.002;
// A mark's rows may differ by 1 px in both images to be taken for the same one. The mean leaves room for the marks
// where the lenses fit less well, and for those that are blurred.
constexpr double most_row_error_px = 0.5;

using Corners = std::vector<std::vector<cv::Point2f>>;  // of each view
using Boards = std::vector<std::vector<cv::Point3f>>;

constexpr std::string_view lens_cause =
    "Are all images of one camera at one zoom, and is the board flat and whole in each?";
constexpr std::string_view pair_cause =
    "Do the images of each pair belong together? They are paired in the order of their names, and must be of one "
    "moment and at one zoom";

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

// The views as they are fitted to.
struct Seen {
  const std::vector<BoardView>& views;
  cv::Size image;
  Boards boards;

  OddView worst(const std::vector<double>& errors_px) const {
    const auto most = std::ranges::max_element(errors_px);
    const auto index = static_cast<std::size_t>(most - errors_px.begin());
    return {index, {views[index].name, *most}};
  }
};

std::unexpected<Misfit> misfit(const OddView& worst, std::string_view what, const std::string& how,
                               std::string_view cause) {
  return std::unexpected(Misfit{
      {"misfit",
       fmt::format("no {} sees the boards like that: {}; farthest off is {}, {:.1f} px. {}", what, how,
                   worst.error.name, worst.error.px, cause),
       {},
       {}},
      worst});
}

// Whether what was found for `what` can be right.
Fit<void> check_errors(const Seen& seen, std::string_view what, double error_px,
                       const std::vector<double>& view_errors_px, std::string_view cause) {
  if (!std::isfinite(error_px)) {
    return std::unexpected(Misfit{{"no-solution", fmt::format("no {} sees the boards like that", what), {}, {}}, {}});
  }
  const OddView worst = seen.worst(view_errors_px);
  const double most_px = most_error * seen.image.width;
  if (error_px > most_px) {
    return misfit(worst, what,
                  fmt::format("the nearest leaves a reprojection error of {:.1f} px, where {:.1f} is too much already",
                              error_px, most_px),
                  cause);
  }
  std::vector<double> errors_px = view_errors_px;
  const auto middle = errors_px.begin() + static_cast<std::ptrdiff_t>(errors_px.size() / 2);
  std::ranges::nth_element(errors_px, middle);
  if (worst.error.px <= std::max(least_odd_error * seen.image.width, most_times_middle * *middle)) return {};
  return misfit(worst, what, fmt::format("one is off by more than {:.0f} times as much as most", most_times_middle),
                cause);
}

Fit<Lens> fit_lens(const Seen& seen, std::string_view what, const Corners& corners) {
  Lens out;
  std::vector<cv::Mat> unused;
  try {
    out.error_px = cv::calibrateCamera(seen.boards, corners, seen.image, out.camera, out.distortion, unused, unused,
                                       cv::noArray(), cv::noArray(), out.view_errors_px, lens_flags);
  } catch (const cv::Exception&) {
    out.error_px = NAN;
  }
  const Fit<void> checked = check_errors(seen, what, out.error_px, out.view_errors_px, lens_cause);
  if (!checked) return std::unexpected(checked.error());
  return out;
}

// Where the right camera is, seen from the left one; the lenses become what suits both.
struct Arrangement {
  cv::Mat rotation;
  cv::Mat translation;
  double error_px = 0;  // RMS
  std::vector<double> view_errors_px;
};

Fit<Arrangement> arrange(const Seen& seen, const Corners& left, const Corners& right, Lens& left_lens,
                         Lens& right_lens) {
  Arrangement out;
  cv::Mat unused;
  cv::Mat errors;
  try {
    out.error_px = cv::stereoCalibrate(seen.boards, left, right, left_lens.camera, left_lens.distortion,
                                       right_lens.camera, right_lens.distortion, seen.image, out.rotation,
                                       out.translation, unused, unused, errors,
                                       lens_flags | cv::CALIB_USE_INTRINSIC_GUESS);
  } catch (const cv::Exception&) {
    out.error_px = NAN;
  }
  for (int i = 0; i < errors.rows; ++i) {
    out.view_errors_px.push_back(std::hypot(errors.at<double>(i, 0), errors.at<double>(i, 1)) / std::sqrt(2));
  }
  const Fit<void> checked = check_errors(seen, "pair of cameras", out.error_px, out.view_errors_px, pair_cause);
  if (!checked) return std::unexpected(checked.error());
  return out;
}

// That it is a pair, and which is which. Leaving views out changes nothing about it.
Fit<void> check_places(const cv::Mat& translation) {
  if (cv::norm(translation) < 1) {
    return std::unexpected(Misfit{
        {"one-camera", "both are the same camera's images, the base line is 0: give those of the other camera", {}, {}},
        {}});
  }
  if (translation.at<double>(0) < -1) return {};
  return std::unexpected(Misfit{
      {"swapped", "the right camera stands to the left of the left one: give the images the other way round", {}, {}},
      {}});
}

Corners corners_in(const std::vector<BoardView>& views, std::vector<cv::Point2f> BoardView::*side) {
  Corners out;
  for (const BoardView& view : views) out.push_back(view.*side);
  return out;
}

}  // namespace

Fit<CalibratedPair> fit_single(const std::vector<BoardView>& views, cv::Size image, const CalibrationBoard& board) {
  const Seen seen{views, image, Boards(views.size(), corners_of(board))};
  const Fit<Lens> lens = fit_lens(seen, "camera", corners_in(views, &BoardView::left));
  if (!lens) return std::unexpected(lens.error());
  CalibratedPair out;
  out.calibration = {.width = image.width,
                     .height = image.height,
                     .left = model_of(*lens),
                     .right = {},
                     .board = board,
                     .pairs = static_cast<int>(views.size()),
                     .reprojection_px = lens->error_px};
  out.worst = seen.worst(lens->view_errors_px).error;
  return out;
}

Fit<CalibratedPair> fit_pair(const std::vector<BoardView>& views, cv::Size image, const CalibrationBoard& board) {
  const Seen seen{views, image, Boards(views.size(), corners_of(board))};
  const Corners left = corners_in(views, &BoardView::left);
  const Corners right = corners_in(views, &BoardView::right);
  Fit<Lens> left_lens = fit_lens(seen, "left camera", left);
  if (!left_lens) return std::unexpected(left_lens.error());
  Fit<Lens> right_lens = fit_lens(seen, "right camera", right);
  if (!right_lens) return std::unexpected(right_lens.error());
  const Fit<Arrangement> found = arrange(seen, left, right, *left_lens, *right_lens);
  if (!found) return std::unexpected(found.error());
  const Fit<void> placed = check_places(found->translation);
  if (!placed) return std::unexpected(placed.error());
  CalibratedPair out;
  out.calibration = {.width = image.width,
                     .height = image.height,
                     .left = model_of(*left_lens),
                     .right = model_of(*right_lens),
                     .board = board,
                     .pairs = static_cast<int>(views.size()),
                     .reprojection_px = found->error_px};
  std::copy_n(found->rotation.ptr<double>(), 9, out.calibration.rotation.begin());
  std::copy_n(found->translation.ptr<double>(), 3, out.calibration.translation_mm.begin());
  const OddView worst = seen.worst(found->view_errors_px);
  out.worst = worst.error;
  const double rows_px = epipolar_error_px(out.calibration, views);
  out.calibration.epipolar_px = rows_px;
  if (rows_px <= most_row_error_px) return out;
  return misfit(worst, "pair of cameras",
                fmt::format("rectified, a corner's rows differ by {:.1f} px, where {:.1f} is too much already", rows_px,
                            most_row_error_px),
                pair_cause);
}

}  // namespace pizarra
