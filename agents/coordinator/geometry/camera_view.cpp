#include "agents/coordinator/geometry/camera_view.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace pizarra::coordinator {

Result<CameraModel> camera_model_from_fact(const Datum& fact) {
  const bool numbers = fact.size() == 8 && std::ranges::all_of(fact.items().subspan(2), &Datum::is_number);
  if (!fact.is_form("camera-model") || !numbers || fact[4].number() <= 0 || fact[7].number() <= 0) {
    return fail("bad-camera-model", "a camera model has a positive focal length and base line", fact);
  }
  return CameraModel{fact[2].number(), fact[3].number(), fact[4].number(),
                     fact[5].number(), fact[6].number(), fact[7].number()};
}

namespace {

// Horizontally, at an angle from the base's -x towards +y.
Eigen::Vector3d direction(double pan_deg) {
  const double facing = (180 - pan_deg) * std::numbers::pi / 180;
  return {std::cos(facing), std::sin(facing), 0};
}

}  // namespace

CameraView::CameraView(const forms::CameraPose& pose, const CameraModel& model, HeadTurn head)
    : model_(model), centre_(pose.at_mm[0], pose.at_mm[1], pose.at_mm[2]) {
  away_ = direction(pose.pan_deg);
  right_ = away_.cross(Eigen::Vector3d::UnitZ());
  const Eigen::Vector3d ahead = direction(pose.pan_deg + head.pan_deg);
  const double downwards = -(pose.tilt_deg + head.tilt_deg) * std::numbers::pi / 180;
  const Eigen::Vector3d level = ahead.cross(Eigen::Vector3d::UnitZ());
  forward_ = std::cos(downwards) * ahead - std::sin(downwards) * Eigen::Vector3d::UnitZ();
  const double roll = pose.roll_deg * std::numbers::pi / 180;
  across_ = std::cos(roll) * level + std::sin(roll) * forward_.cross(level);
  down_ = forward_.cross(across_);
}

Eigen::Vector3d CameraView::from_camera(const Eigen::Vector3d& seen) const {
  return centre_ + seen.x() * across_ + seen.y() * down_ + seen.z() * forward_;
}

Eigen::Vector3d CameraView::to_camera(const Eigen::Vector3d& point) const {
  const Eigen::Vector3d apart = point - centre_;
  return {apart.dot(across_), apart.dot(down_), apart.dot(forward_)};
}

Datum CameraView::numbers() const {
  const auto as_list = [](const Eigen::Vector3d& at) { return list(at.x(), at.y(), at.z()); };
  return list(model_.focal_px, model_.centre_x_px, model_.centre_y_px, model_.base_line_mm, as_list(centre_),
              as_list(across_), as_list(down_), as_list(forward_));
}

Sight CameraView::sight(const Eigen::Vector3d& point) const {
  const Eigen::Vector3d from_centre = point - centre_;
  const double depth = from_centre.dot(forward_);
  assert(depth > 0);
  const double x = from_centre.dot(across_) + model_.base_line_mm / 2;
  const double y = from_centre.dot(down_);
  return {model_.centre_x_px + model_.focal_px * x / depth, model_.centre_y_px + model_.focal_px * y / depth,
          from_centre.norm(), depth};
}

bool CameraView::shows(const Eigen::Vector3d& point, double around_mm) const {
  const double depth = (point - centre_).dot(forward_);
  if (depth <= around_mm) return false;
  const Sight left = sight(point);
  const double around_px = model_.focal_px * around_mm / depth;
  const double right_x_px = left.x_px - model_.focal_px * model_.base_line_mm / depth;
  return right_x_px >= around_px && left.x_px <= model_.width_px - around_px && left.y_px >= around_px &&
         left.y_px <= model_.height_px - around_px;
}

std::array<Eigen::Vector3d, 2> CameraView::eyes() const {
  const Eigen::Vector3d aside = model_.base_line_mm / 2 * across_;
  return {centre_ - aside, centre_ + aside};
}

}  // namespace pizarra::coordinator
