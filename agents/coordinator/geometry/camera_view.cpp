#include "agents/coordinator/geometry/camera_view.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cassert>
#include <cmath>

#include "lisp/numbers.hpp"

namespace pizarra::coordinator {

Result<CameraModel> camera_model_from_fact(const Datum& fact) {
  const bool numbers = fact.size() == 8 && std::ranges::all_of(fact.items().subspan(2), &Datum::is_number);
  if (!fact.is_form("camera-model") || !numbers || fact[4].number() <= 0 || fact[7].number() <= 0) {
    return fail("bad-camera-model", "a camera model has a positive focal length and base line", fact);
  }
  return CameraModel{fact[2].number(), fact[3].number(), fact[4].number(),
                     fact[5].number(), fact[6].number(), fact[7].number()};
}

CameraView::CameraView(const forms::CameraPose& pose, const CameraModel& model, HeadTurn head) : model_(model) {
  const double facing = radians(180 - pose.pan_deg);
  away_ = {std::cos(facing), std::sin(facing), 0};
  right_ = away_.cross(Eigen::Vector3d::UnitZ());
  const Eigen::Isometry3d frame = ptu::camera_frame(pose) * ptu::head_turn(pose, head);
  centre_ = frame.translation();
  across_ = frame.linear().col(0);
  down_ = frame.linear().col(1);
  forward_ = frame.linear().col(2);
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
