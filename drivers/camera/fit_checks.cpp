#include "drivers/camera/fit_checks.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <opencv2/calib3d.hpp>

#include "lisp/numbers.hpp"

namespace pizarra::camera {
namespace {

// Of the image's width: no blur leaves corners so far off, but images that do not belong together do.
constexpr double most_error = 0.0025;
// A view is no part of the rest that is so many times farther off than the middle one, and so far, of the width: what
// is exact in all other views leaves a little anywhere.
constexpr double most_times_middle = 4;
constexpr double least_odd_error = 0.002;
// A mark's rows may differ by 1 px in both images to be taken for the same one. The mean leaves room for the marks
// where the lenses fit less well, and for those that are blurred.
constexpr double most_row_error_px = 0.5;
// The uncertainty that the views leave, as a part of the focal length or the base line. The deviations hold near the
// truth; boards hardly tilted to one another may lead far from it.
constexpr double most_deviation = 0.02;
constexpr double least_base_line_mm = 2;

std::unexpected<Misfit> hopeless(std::string symbol, std::string sentence) {
  return std::unexpected(Misfit{{std::move(symbol), std::move(sentence), {}, {}}, {}});
}

std::unexpected<Misfit> misfit(const OddView& worst, std::string_view what, const std::string& how,
                               std::string_view cause) {
  return std::unexpected(Misfit{{"misfit",
                                 fmt::format("no {} sees the boards like that: {}; farthest off is {}, {:.1f} px. {}",
                                             what, how, worst.error.name, worst.error.px, cause),
                                 {},
                                 {}},
                                worst});
}

std::unexpected<Misfit> uncertain(const std::string& what) {
  return hopeless("uncertain", what +
                                   ". Hold the board at more angles, tilted by up to 45 degrees each way, near and "
                                   "far, and take those images as well");
}

}  // namespace

double tilts_deg(const std::vector<cv::Mat>& turns) {
  std::vector<cv::Vec3d> normals;
  for (const cv::Mat& turn : turns) {
    cv::Matx33d rotation;
    cv::Rodrigues(turn, rotation);
    normals.emplace_back(rotation(0, 2), rotation(1, 2), rotation(2, 2));
  }
  double least_cosine = 1;
  for (const cv::Vec3d& a : normals) {
    for (const cv::Vec3d& b : normals) least_cosine = std::min(least_cosine, a.dot(b));
  }
  return degrees(std::acos(std::max(-1.0, least_cosine)));
}

OddView worst_of(const std::vector<BoardView>& views, const std::vector<double>& errors_px) {
  const auto most = std::ranges::max_element(errors_px);
  const auto index = static_cast<std::size_t>(most - errors_px.begin());
  return {index, {views[index].name, *most}};
}

Fit<void> check_errors(const FitErrors& fit, std::string_view cause) {
  if (!std::isfinite(fit.error_px)) {
    return hopeless("no-solution", fmt::format("no {} sees the boards like that", fit.what));
  }
  const OddView worst = worst_of(fit.views, fit.view_errors_px);
  const double most_px = most_error * fit.width_px;
  if (fit.error_px > most_px) {
    return misfit(worst, fit.what,
                  fmt::format("the nearest leaves a reprojection error of {:.1f} px, where {:.1f} is too much already",
                              fit.error_px, most_px),
                  cause);
  }
  std::vector<double> errors_px = fit.view_errors_px;
  const auto middle = errors_px.begin() + static_cast<std::ptrdiff_t>(errors_px.size() / 2);
  std::ranges::nth_element(errors_px, middle);
  if (worst.error.px <= std::max(least_odd_error * fit.width_px, most_times_middle * *middle)) return {};
  return misfit(worst, fit.what, fmt::format("one is off by more than {:.0f} times as much as most", most_times_middle),
                cause);
}

Fit<void> check_tilts(std::string_view what, const std::vector<cv::Mat>& turns) {
  const double tilts = tilts_deg(turns);
  if (tilts >= least_tilts_deg) return {};
  return uncertain(
      fmt::format("to the {} the boards are tilted by {:.0f} degrees to one another at most, and {:.0f} "
                  "are the least that tells a camera from others",
                  what, tilts, least_tilts_deg));
}

Fit<void> check_deviations(const StereoCalibration& c) {
  const double focal_px = c.is_single() ? c.left.focal_x_px : std::min(c.left.focal_x_px, c.right.focal_x_px);
  const double base_line_mm = cv::norm(cv::Vec3d(c.translation_mm.data()));
  if (c.deviations.focal_px > most_deviation * focal_px) {
    return uncertain(
        fmt::format("the boards leave the focal length open: {:.0f} px, give or take {:.0f}, where {:.0f} "
                    "are too much already",
                    focal_px, c.deviations.focal_px, most_deviation * focal_px));
  }
  if (c.deviations.base_line_mm > most_deviation * base_line_mm) {
    return uncertain(
        fmt::format("the boards leave the base line open: {:.1f} mm, give or take {:.1f}, where {:.1f} "
                    "are too much already",
                    base_line_mm, c.deviations.base_line_mm, most_deviation * base_line_mm));
  }
  return {};
}

Fit<void> check_places(const cv::Vec3d& at) {
  if (cv::norm(at) < least_base_line_mm) {
    return hopeless("one-camera",
                    "both are the same camera's images, the base line is 0: give those of the other camera");
  }
  if (std::abs(at[0]) < std::abs(at[1])) {
    return hopeless("turned", fmt::format("the right camera stands {} the left one, not beside it: turn the images of "
                                          "both by a quarter, {}clockwise",
                                          at[1] > 0 ? "above" : "below", at[1] > 0 ? "" : "counter"));
  }
  // Two images that do not belong together may seem to show depths of any size.
  if (at[0] < 0 || std::abs(at[0]) < std::abs(at[2])) return {};
  return hopeless("swapped",
                  "the right camera stands to the left of the left one: give the images the other way round");
}

Fit<void> check_rows(double rows_px, const OddView& worst) {
  if (rows_px <= most_row_error_px) return {};
  return misfit(worst, "pair of cameras",
                fmt::format("rectified, a corner's rows differ by {:.1f} px, where {:.1f} is too much already", rows_px,
                            most_row_error_px),
                pair_cause);
}

Fit<void> check_depths(const cv::Vec3d& at, const OddView& worst) {
  if (std::abs(at[0]) >= std::abs(at[2])) return {};
  return misfit(
      worst, "pair of cameras",
      fmt::format("the right one would stand {} the left one, not beside it", at[2] > 0 ? "behind" : "before"),
      pair_cause);
}

}  // namespace pizarra::camera
