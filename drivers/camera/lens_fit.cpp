#include "drivers/camera/lens_fit.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <opencv2/calib3d.hpp>

#include "drivers/camera/fit_checks.hpp"
#include "drivers/camera/fit_deviations.hpp"

namespace pizarra::camera {
namespace {

// Few boards near the corners say little about what k3 does there.
constexpr int lens_flags = cv::CALIB_FIX_K3;

using Corners = std::vector<std::vector<cv::Point2f>>;  // of each view
using Boards = std::vector<std::vector<cv::Point3f>>;

// The views as they are fitted to.
struct Seen {
  const std::vector<BoardView>& views;
  cv::Size image;
  Boards boards;

  FitErrors errors(std::string_view what, double error_px, const std::vector<double>& view_errors_px) const {
    return {what, error_px, view_errors_px, views, image.width};
  }
};

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

Fit<Lens> fit_lens(const Seen& seen, std::string_view what, const Corners& corners, const TellStep& tell) {
  tell(fmt::format("fitting the {} to {} boards", what, corners.size()));
  Lens out;
  std::vector<cv::Mat> turns;
  std::vector<cv::Mat> unused;
  try {
    out.error_px = cv::calibrateCamera(seen.boards, corners, seen.image, out.camera, out.distortion, turns, unused,
                                       cv::noArray(), cv::noArray(), out.view_errors_px, lens_flags);
  } catch (const cv::Exception&) {
    out.error_px = NAN;
  }
  const Fit<void> checked = check_errors(seen.errors(what, out.error_px, out.view_errors_px), lens_cause);
  if (!checked) return std::unexpected(checked.error());
  const Fit<void> tilted = check_tilts(what, turns);
  if (!tilted) return std::unexpected(tilted.error());
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
    out.error_px = cv::stereoCalibrate(
        seen.boards, left, right, left_lens.camera, left_lens.distortion, right_lens.camera, right_lens.distortion,
        seen.image, out.rotation, out.translation, unused, unused, errors, lens_flags | cv::CALIB_USE_INTRINSIC_GUESS);
  } catch (const cv::Exception&) {
    out.error_px = NAN;
  }
  for (int i = 0; i < errors.rows; ++i) {
    out.view_errors_px.push_back(std::hypot(errors.at<double>(i, 0), errors.at<double>(i, 1)) / std::sqrt(2));
  }
  const Fit<void> checked = check_errors(seen.errors("pair of cameras", out.error_px, out.view_errors_px), pair_cause);
  if (!checked) return std::unexpected(checked.error());
  return out;
}

Corners corners_in(const std::vector<BoardView>& views, std::vector<cv::Point2f> BoardView::*side) {
  Corners out;
  for (const BoardView& view : views) out.push_back(view.*side);
  return out;
}

Boards boards_in(const std::vector<BoardView>& views, const CalibrationBoard& board) {
  Boards out;
  for (const BoardView& view : views) out.push_back(corners_of(view, board));
  return out;
}

}  // namespace

Fit<CalibratedPair> fit_single(const std::vector<BoardView>& views, cv::Size image, const CalibrationBoard& board,
                               const TellStep& tell) {
  const Seen seen{views, image, boards_in(views, board)};
  const Fit<Lens> lens = fit_lens(seen, "camera", corners_in(views, &BoardView::left), tell);
  if (!lens) return std::unexpected(lens.error());
  CalibratedPair out;
  out.calibration = {.width = image.width,
                     .height = image.height,
                     .left = model_of(*lens),
                     .right = {},
                     .board = board,
                     .pairs = static_cast<int>(views.size()),
                     .reprojection_px = lens->error_px};
  out.worst = worst_of(views, lens->view_errors_px).error;
  out.calibration.deviations = deviations_of(out.calibration, views);
  const Fit<void> certain = check_deviations(out.calibration);
  if (!certain) return std::unexpected(certain.error());
  return out;
}

Fit<CalibratedPair> fit_pair(const std::vector<BoardView>& views, cv::Size image, const CalibrationBoard& board,
                             const TellStep& tell) {
  const Seen seen{views, image, boards_in(views, board)};
  const Corners left = corners_in(views, &BoardView::left);
  const Corners right = corners_in(views, &BoardView::right);
  Fit<Lens> left_lens = fit_lens(seen, "left camera", left, tell);
  if (!left_lens) return std::unexpected(left_lens.error());
  Fit<Lens> right_lens = fit_lens(seen, "right camera", right, tell);
  if (!right_lens) return std::unexpected(right_lens.error());
  tell(fmt::format("fitting both cameras to {} boards", views.size()));
  const Fit<Arrangement> found = arrange(seen, left, right, *left_lens, *right_lens);
  if (!found) return std::unexpected(found.error());
  const cv::Vec3d at(found->translation.ptr<double>());
  const Fit<void> placed = check_places(at);
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
  out.calibration.epipolar_px = epipolar_error_px(out.calibration, views);
  const OddView worst = worst_of(views, found->view_errors_px);
  out.worst = worst.error;
  const Fit<void> level = check_rows(out.calibration.epipolar_px, worst);
  if (!level) return std::unexpected(level.error());
  const Fit<void> beside = check_depths(at, worst);
  if (!beside) return std::unexpected(beside.error());
  out.calibration.deviations = deviations_of(out.calibration, views);
  const Fit<void> certain = check_deviations(out.calibration);
  if (!certain) return std::unexpected(certain.error());
  return out;
}

}  // namespace pizarra::camera
