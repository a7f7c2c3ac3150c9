#include "drivers/simulation/camera_lens.hpp"

#include <Eigen/LU>
#include <cmath>

namespace pizarra::simulation {

namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;

constexpr int most_steps = 30;
constexpr double near_enough = 1e-10;
constexpr double farthest = 1.5;          // times as far from the middle as the lens shows it
constexpr double least_stretching = 0.1;  // of an image along any direction; less, and it is about to fold

struct Bent {
  Vector2d at;
  Matrix2d moves;  // of `at`, by how the straight point moves
};

// The model of OpenCV.
Bent distorted(const LensDistortion& lens, const Vector2d& point) {
  const auto& [k1, k2, p1, p2, k3] = lens;
  const double x = point.x();
  const double y = point.y();
  const double r2 = point.squaredNorm();
  const double radial = 1 + r2 * (k1 + r2 * (k2 + r2 * k3));
  const double slope = k1 + r2 * (2 * k2 + r2 * 3 * k3);  // of `radial`, by r2
  Bent bent;
  bent.at = radial * point + Vector2d(2 * p1 * x * y + p2 * (r2 + 2 * x * x), p1 * (r2 + 2 * y * y) + 2 * p2 * x * y);
  bent.moves = radial * Matrix2d::Identity() + 2 * slope * point * point.transpose();
  bent.moves +=
      Matrix2d{{2 * p1 * y + 6 * p2 * x, 2 * p1 * x + 2 * p2 * y}, {2 * p1 * x + 2 * p2 * y, 6 * p1 * y + 2 * p2 * x}};
  return bent;
}

}  // namespace

// Newton's method, from where there is no lens.
std::optional<Vector2d> undistorted(const LensDistortion& lens, const Vector2d& point) {
  Vector2d straight = point;
  for (int step = 0; step < most_steps; ++step) {
    const Bent bent = distorted(lens, straight);
    if (bent.moves.trace() < 2 * least_stretching || bent.moves.determinant() < least_stretching * least_stretching) {
      return std::nullopt;
    }
    const Vector2d off = point - bent.at;
    if (off.norm() < near_enough) return straight;
    straight += bent.moves.inverse() * off;
  }
  return std::nullopt;
}

bool shows_all_once(const CameraConfig& camera) {
  const camera::StereoModel& model = camera.model;
  for (int y = 0; y < model.height; ++y) {
    for (int x = 0; x < model.width; ++x) {
      const Vector2d point((x - model.centre_x_px) / model.focal_px, (y - model.centre_y_px) / model.focal_px);
      const std::optional<Vector2d> straight = undistorted(camera.lens, point);
      if (!straight || straight->norm() > farthest * point.norm()) return false;
    }
  }
  return true;
}

camera::StereoCalibration calibration_of(const CameraConfig& camera) {
  const camera::StereoModel& model = camera.model;
  const camera::LensModel lens{.focal_x_px = model.focal_px,
                               .focal_y_px = model.focal_px,
                               .centre_x_px = model.centre_x_px,
                               .centre_y_px = model.centre_y_px,
                               .distortion = camera.lens};
  camera::StereoCalibration calibration;
  calibration.width = model.width;
  calibration.height = model.height;
  calibration.left = calibration.right = lens;
  calibration.translation_mm = {-model.base_line_mm, 0, 0};
  return calibration;
}

}  // namespace pizarra::simulation
