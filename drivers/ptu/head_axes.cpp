#include "drivers/ptu/head_axes.hpp"

#include <cmath>

#include "lisp/numbers.hpp"

namespace pizarra::ptu {

namespace {

Eigen::Isometry3d turned_about(const forms::HeadAxis& axis, double deg) {
  const Eigen::Vector3d at(axis.at_mm.data());
  const Eigen::Vector3d along = Eigen::Vector3d(axis.along.data()).normalized();
  return Eigen::Translation3d(at) * Eigen::AngleAxisd(radians(deg), along) * Eigen::Translation3d(-at);
}

}  // namespace

Eigen::Isometry3d camera_frame(const forms::CameraPose& pose) {
  const double facing = radians(180 - pose.pan_deg);
  const Eigen::Vector3d ahead(std::cos(facing), std::sin(facing), 0);
  const Eigen::Vector3d level = ahead.cross(Eigen::Vector3d::UnitZ());
  const double downwards = radians(-pose.tilt_deg);
  const Eigen::Vector3d forward = std::cos(downwards) * ahead - std::sin(downwards) * Eigen::Vector3d::UnitZ();
  const double roll = radians(pose.roll_deg);
  const Eigen::Vector3d across = std::cos(roll) * level + std::sin(roll) * forward.cross(level);
  Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
  frame.linear() << across, forward.cross(across), forward;
  frame.translation() = Eigen::Vector3d(pose.at_mm.data());
  return frame;
}

Eigen::Isometry3d head_turn(const forms::CameraPose& pose, HeadTurn turn) {
  const forms::HeadAxes axes = axes_of(pose);
  return turned_about(axes.pan, turn.pan_deg) * turned_about(axes.tilt, turn.tilt_deg);
}

forms::HeadAxes axes_of(const forms::CameraPose& pose) {
  if (pose.axes) return *pose.axes;
  const double tilt = radians(pose.tilt_deg);
  const double roll = radians(pose.roll_deg);
  const std::array<double, 3> down{std::sin(roll) * std::cos(tilt), std::cos(roll) * std::cos(tilt), -std::sin(tilt)};
  return {.pan = {.along = down}, .tilt = {.along = {std::cos(roll), -std::sin(roll), 0}}};
}

}  // namespace pizarra::ptu
