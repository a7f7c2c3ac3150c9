#include "drivers/camera/stereo_geometry.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

namespace pizarra::camera {
namespace {

// An ordinary webcam sees about 60 degrees.
constexpr double usual_focal_of_width = 0.87;
constexpr double usual_learned_at_mm = 500;

bool is_single(const forms::CameraSetup& setup) { return setup.arrangement == forms::CameraSetup::Arrangement::single; }

double learned_at_mm(const forms::CameraSetup& setup) {
  return setup.learned_at_mm > 0 ? setup.learned_at_mm : usual_learned_at_mm;
}

StereoModel plain_model(const forms::CameraSetup& setup, cv::Size image) {
  StereoModel model;
  model.width = image.width;
  model.height = image.height;
  model.focal_px = setup.focal_px > 0 ? setup.focal_px : usual_focal_of_width * image.width;
  model.centre_x_px = (image.width - 1) / 2.0;
  model.centre_y_px = (image.height - 1) / 2.0;
  model.base_line_mm = setup.base_line_mm;
  if (is_single(setup)) {
    model.base_line_mm = 0;
    model.learned_at_mm = learned_at_mm(setup);
  }
  return model;
}

// Corners are found with an error of their own in either image, which makes rows differ by as much as it leaves of the
// reprojection. The lenses leave the rest of that difference, as a standard deviation, and no less of it along the
// rows.
double unrectified_px(const StereoCalibration& calibration) {
  const double rows_px = calibration.epipolar_px * std::sqrt(CV_PI / 2);
  const double corners_px = calibration.reprojection_px;
  return std::sqrt(std::max(0.0, rows_px * rows_px - corners_px * corners_px));
}

StereoDeviations deviations_of(const StereoCalibration& calibration, double focal_px) {
  const double larger = focal_px / calibration.left.focal_x_px;
  return {calibration.deviations.focal_px * larger, calibration.deviations.base_line_mm,
          unrectified_px(calibration) * larger};
}

}  // namespace

Result<StereoGeometry> StereoGeometry::make(const forms::CameraSetup& setup,
                                            const std::optional<StereoCalibration>& calibration, cv::Size image) {
  if (!calibration) {
    StereoGeometry plain;
    plain.model_ = plain_model(setup, image);
    return plain;
  }
  if (image != cv::Size(calibration->width, calibration->height)) {
    return fail("wrong-size",
                fmt::format("the camera's images are {}x{}, and {} is of {}x{}", image.width, image.height,
                            setup.calibration_file, calibration->width, calibration->height));
  }
  if (calibration->is_single() != is_single(setup)) {
    return fail("wrong-calibration", fmt::format("{} is of {}, and the cell has {}", setup.calibration_file,
                                                 calibration->is_single() ? "one camera" : "a pair of cameras",
                                                 is_single(setup) ? "one" : "a pair"));
  }
  StereoGeometry geometry(*calibration);
  if (is_single(setup)) geometry.model_.learned_at_mm = learned_at_mm(setup);
  return geometry;
}

StereoGeometry::Lens StereoGeometry::lens_of(const LensModel& model) {
  Lens lens;
  lens.camera = {model.focal_x_px, 0, model.centre_x_px, 0, model.focal_y_px, model.centre_y_px, 0, 0, 1};
  lens.distortion = cv::Vec<double, 5>(model.distortion.data());
  return lens;
}

StereoGeometry::StereoGeometry(const StereoCalibration& calibration) : rectifies_(true) {
  lenses_[0] = lens_of(calibration.left);
  if (calibration.is_single()) {
    see_with_one(calibration);
  } else {
    see_with_two(calibration);
  }
}

// Nothing black at the borders: a mark must not meet an edge that is none. Pixels are made square.
void StereoGeometry::see_with_one(const StereoCalibration& calibration) {
  const cv::Size size(calibration.width, calibration.height);
  Lens& lens = lenses_[0];
  const cv::Matx33d best =
      cv::Mat(cv::getOptimalNewCameraMatrix(lens.camera, lens.distortion, size, 0, size, nullptr, true));
  const double focal_px = std::max(best(0, 0), best(1, 1));
  lens.rotation = cv::Matx33d::eye();
  lens.projection = {focal_px, 0, best(0, 2), 0, 0, focal_px, best(1, 2), 0, 0, 0, 1, 0};
  cv::initUndistortRectifyMap(lens.camera, lens.distortion, lens.rotation, lens.projection, size, CV_16SC2,
                              lens.map_whole, lens.map_fraction);
  model_ = {.width = size.width,
            .height = size.height,
            .focal_px = focal_px,
            .centre_x_px = best(0, 2),
            .centre_y_px = best(1, 2),
            .base_line_mm = 0,
            .learned_at_mm = usual_learned_at_mm};
}

void StereoGeometry::see_with_two(const StereoCalibration& calibration) {
  lenses_[1] = lens_of(calibration.right);
  const cv::Size size(calibration.width, calibration.height);
  const cv::Matx33d rotation(calibration.rotation.data());
  const cv::Vec3d translation(calibration.translation_mm.data());
  cv::Mat unused;
  // Nothing black at the borders: a mark must not meet an edge that is none.
  cv::stereoRectify(lenses_[0].camera, lenses_[0].distortion, lenses_[1].camera, lenses_[1].distortion, size, rotation,
                    translation, lenses_[0].rotation, lenses_[1].rotation, lenses_[0].projection, lenses_[1].projection,
                    unused, cv::CALIB_ZERO_DISPARITY, 0);
  for (Lens& lens : lenses_) {
    cv::initUndistortRectifyMap(lens.camera, lens.distortion, lens.rotation, lens.projection, size, CV_16SC2,
                                lens.map_whole, lens.map_fraction);
  }
  const cv::Matx34d& projection = lenses_[1].projection;
  model_ = {.width = size.width,
            .height = size.height,
            .focal_px = projection(0, 0),
            .centre_x_px = projection(0, 2),
            .centre_y_px = projection(1, 2),
            .base_line_mm = -projection(0, 3) / projection(0, 0),
            .deviations = deviations_of(calibration, projection(0, 0))};
}

cv::Mat StereoGeometry::rectified(const cv::Mat& image, Side side) const {
  if (!rectifies_) return image;
  const Lens& lens = lenses_[side == Side::right];
  cv::Mat out;
  cv::remap(image, out, lens.map_whole, lens.map_fraction, cv::INTER_LINEAR, cv::BORDER_REPLICATE);
  return out;
}

cv::Point2d StereoGeometry::rectified(cv::Point2d point, Side side) const {
  if (!rectifies_) return point;
  const Lens& lens = lenses_[side == Side::right];
  std::vector<cv::Point2d> out;
  cv::undistortPoints(std::vector{point}, out, lens.camera, lens.distortion, lens.rotation, lens.projection);
  return out.front();
}

cv::Point2d StereoGeometry::as_taken(cv::Point2d point, Side side) const {
  if (!rectifies_) return point;
  const Lens& lens = lenses_[side == Side::right];
  const cv::Matx33d camera = lens.projection.get_minor<3, 3>(0, 0);
  const cv::Vec3d ray = lens.rotation.t() * (camera.inv() * cv::Vec3d(point.x, point.y, 1));
  std::vector<cv::Point2d> out;
  cv::projectPoints(std::vector<cv::Point3d>{{ray[0], ray[1], ray[2]}}, cv::Vec3d(), cv::Vec3d(), lens.camera,
                    lens.distortion, out);
  return out.front();
}

}  // namespace pizarra::camera
