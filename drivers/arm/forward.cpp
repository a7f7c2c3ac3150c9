#include <algorithm>
#include <cmath>

#include "drivers/arm/kinematics.hpp"
#include "drivers/arm/placement.hpp"
#include "drivers/arm/solution.hpp"

namespace pizarra::arm {

namespace {

using Eigen::Vector3d;

Vector3d track_offset(const ArmModel& model, const Posture& posture) {
  return posture.track_mm * (model.track_along_x ? Vector3d::UnitX() : Vector3d::UnitY());
}

Vector3d level_direction(double heading_deg) {
  return {std::cos(radians(heading_deg)), std::sin(radians(heading_deg)), 0};
}

}  // namespace

ToolPose forward(const ArmModel& model, const Joints& joints) {
  const Posture posture = posture_of(model, joints);
  const Placement placed = place(model, posture);
  ToolPose pose = ToolPose::Identity();
  const Eigen::Matrix3d pitched = placed.forearm * about_z(-posture.roll_deg) * about_y(posture.pitch_deg);
  pose.linear() = pitched * about_z(-posture.spin_deg);
  pose.translation() = placed.wrist_mm + track_offset(model, posture) +
                       (model.wrist_mm + model.tool_mm) * pitched.col(2) + model.wrist_across_mm * pitched.col(0);
  return pose;
}

ToolPose nearest_attainable(const ArmModel& model, const ToolPose& pose, const Joints& near) {
  const bool upright = model.build == Build::articulated || model.build == Build::polar;
  const bool confined = upright && model.axis_of(Role::pitch) && !model.axis_of(Role::roll);
  if (!confined) return pose;
  const Posture from = posture_of(model, near);
  // The tool's direction lies in the plane that axis 1 turns, and so does the point.
  const Vector3d point = pose.translation() - track_offset(model, from);
  if (std::hypot(point.x(), point.y()) < on_axis_1_mm) return pose;
  const double beside = std::asin(std::clamp(model.side_mm / std::hypot(point.x(), point.y()), -1.0, 1.0));
  const Vector3d across = about_z(-degrees(beside)) * Vector3d::UnitZ().cross(point).normalized();
  const Vector3d approach = pose.linear().col(2);
  const Vector3d within = approach - approach.dot(across) * across;
  if (within.norm() < 1e-3) return pose;
  ToolPose attainable = pose;
  attainable.linear() = Eigen::Quaterniond::FromTwoVectors(approach, within) * pose.linear();
  return attainable;
}

Stretch stretch_of(const ArmModel& model, const Joints& joints) {
  const Posture posture = posture_of(model, joints);
  const Vector3d wrist = place(model, posture).wrist_mm;
  const double up = wrist.z() - model.height_mm;
  if (model.build == Build::gantry) return {Vector3d::UnitX(), wrist.x(), up};
  const double radius = std::hypot(wrist.x(), wrist.y());
  if (model.build == Build::scara && radius > on_axis_1_mm) {
    return {Vector3d(wrist.x() / radius, wrist.y() / radius, 0), radius, up};
  }
  const Vector3d ahead = level_direction(posture.place[0]);
  return {ahead, wrist.dot(ahead) - model.offset_mm, up};
}

std::vector<Vector3d> skeleton(const ArmModel& model, const Joints& joints) {
  const Posture posture = posture_of(model, joints);
  const ToolPose tool = forward(model, joints);
  const Vector3d carried = track_offset(model, posture);
  const Vector3d wrist = place(model, posture).wrist_mm + carried;
  const Vector3d flange = tool.translation() - model.tool_mm * tool.linear().col(2);
  if (model.build == Build::gantry) {
    return {carried + Vector3d(wrist.x(), wrist.y(), model.height_mm), wrist, flange};
  }
  if (model.build == Build::scara) {
    const Vector3d shoulder = carried + Vector3d(0, 0, model.height_mm);
    const Vector3d elbow = shoulder + model.upper_arm_mm * level_direction(posture.place[0]);
    return {carried, shoulder, elbow, {wrist.x(), wrist.y(), model.height_mm}, wrist, flange};
  }
  const Vector3d ahead = level_direction(posture.place[0]);
  const Vector3d shoulder = carried + model.offset_mm * ahead + model.side_mm * Vector3d::UnitZ().cross(ahead) +
                            Vector3d(0, 0, model.height_mm);
  if (model.build == Build::polar) return {carried, shoulder, wrist, flange};
  const double th1 = radians(posture.place[1]);
  const Vector3d elbow = shoulder + model.upper_arm_mm * (std::cos(th1) * ahead + std::sin(th1) * Vector3d::UnitZ());
  return {carried, shoulder, elbow, wrist, flange};
}

}  // namespace pizarra::arm
