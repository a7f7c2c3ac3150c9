#include "drivers/simulation/render/eye.hpp"

#include <cmath>

#include "lisp/numbers.hpp"

namespace pizarra::simulation {

Eigen::Vector3d Eye::project(const Eigen::Vector3d& point_mm) const {
  const Eigen::Vector3d seen = axes * (point_mm - position_mm);
  return {centre_x_px + focal_px * seen.x() / seen.z(), centre_y_px + focal_px * seen.y() / seen.z(), seen.z()};
}

Eigen::Matrix3d Eye::plane_to_pixels(const Eigen::Vector3d& corner_mm, const Eigen::Vector3d& right_mm,
                                     const Eigen::Vector3d& down_mm) const {
  Eigen::Matrix3d plane;
  plane << right_mm, down_mm, corner_mm - position_mm;
  Eigen::Matrix3d pinhole = Eigen::Matrix3d::Identity();
  pinhole(0, 0) = pinhole(1, 1) = focal_px;
  pinhole(0, 2) = centre_x_px;
  pinhole(1, 2) = centre_y_px;
  return pinhole * axes * plane;
}

Eye make_eye(const CameraConfig& camera, Side side) {
  const double pan = radians(camera.pose.pan_deg);
  const double tilt = radians(camera.pose.tilt_deg);
  const Eigen::Vector3d forward(-std::cos(pan) * std::cos(tilt), std::sin(pan) * std::cos(tilt), std::sin(tilt));
  const double roll = radians(camera.pose.roll_deg);
  const Eigen::Vector3d level = forward.cross(Eigen::Vector3d::UnitZ()).normalized();
  const Eigen::Vector3d right = std::cos(roll) * level + std::sin(roll) * forward.cross(level);
  Eye eye{.width = camera.model.width,
          .height = camera.model.height,
          .focal_px = camera.model.focal_px,
          .centre_x_px = camera.model.centre_x_px,
          .centre_y_px = camera.model.centre_y_px,
          .position_mm = Eigen::Vector3d(camera.pose.at_mm[0], camera.pose.at_mm[1], camera.pose.at_mm[2]),
          .axes = {}};
  eye.axes.row(0) = right;
  eye.axes.row(1) = forward.cross(right);
  eye.axes.row(2) = forward;
  const Eigen::Isometry3d turned = ptu::head_turn(camera.pose, camera.turn);
  eye.position_mm += eye.axes.transpose() * turned.translation();
  eye.axes = turned.linear().transpose() * eye.axes;
  eye.position_mm += eye.axes.row(0).transpose() * camera.model.base_line_mm * (side == Side::left ? -0.5 : 0.5);
  return eye;
}

}  // namespace pizarra::simulation
