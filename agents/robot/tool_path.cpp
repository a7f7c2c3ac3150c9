#include "agents/robot/tool_path.hpp"

#include <cmath>
#include <fmt/format.h>
#include <numeric>

namespace pizarra::robot {

ToolPath::ToolPath(const arm::ArmModel& model, const arm::Joints& from, Track track)
    : model_(model), track_(track), joints_(from), pose_(arm::forward(model, from)) {}

Result<arm::Joints> ToolPath::reach(const Eigen::Vector3d& point_mm) const {
  if (waypoints_.size() >= max_waypoints) {
    return fail("too-long", fmt::format("a motion has at most {} waypoints", max_waypoints));
  }
  arm::ToolPose pose = pose_;
  pose.translation() = point_mm;
  pose = arm::nearest_attainable(model_, pose, joints_);
  Result<arm::Joints> joints =
      track_ == Track::stays ? arm::inverse_in_place(model_, pose, joints_) : arm::inverse(model_, pose, joints_);
  if (!joints) return joints;
  Result<void> kept = keeps_posture(*joints, point_mm);
  if (!kept && track_ == Track::helps) {
    joints = arm::inverse_elsewhere(model_, pose, joints_, posture_change_deg);
    if (joints) kept = keeps_posture(*joints, point_mm);
  }
  if (!kept) return fail(kept);
  return joints;
}

Result<void> ToolPath::keeps_posture(const arm::Joints& joints, const Eigen::Vector3d& point_mm) const {
  for (std::size_t axis = 0; axis < joints.size(); ++axis) {
    const double widest = arm::slides(model_.axes[axis].role) ? posture_change_mm : posture_change_deg;
    if (std::abs(joints[axis] - joints_[axis]) <= widest) continue;
    return fail("joint-limit",
                fmt::format("axis {} would have to change its posture on the way to ({:.1f} {:.1f} {:.1f})", axis + 1,
                            point_mm.x(), point_mm.y(), point_mm.z()),
                to_datum(axis + 1));
  }
  return {};
}

void ToolPath::append(const arm::Joints& joints, const Eigen::Vector3d& point_mm) {
  waypoints_.push_back(joints);
  joints_ = joints;
  pose_.translation() = point_mm;
}

bool ToolPath::is_straight(const Line& line, const arm::Joints& to) const {
  const Eigen::Matrix3d before = arm::forward(model_, joints_).linear();
  const double turned = (arm::forward(model_, to).linear() - before).norm();
  arm::Joints between = to;
  for (const double part : {0.25, 0.5, 0.75}) {
    for (std::size_t axis = 0; axis < to.size(); ++axis) between[axis] = std::lerp(joints_[axis], to[axis], part);
    const arm::ToolPose pose = arm::forward(model_, between);
    const Eigen::Vector3d off = pose.translation() - line.start_mm;
    if ((off - off.dot(line.along) * line.along).norm() > deviation_mm) return false;
    if ((pose.linear() - before).norm() > turned + tilt_rad) return false;
  }
  return true;
}

LineEnd ToolPath::advance(const Line& line, double from_mm, double to_mm) {
  const Result<arm::Joints> joints = reach(line.at(to_mm));
  if (!joints) return {from_mm, joints.error()};
  if (is_straight(line, *joints)) {
    append(*joints, line.at(to_mm));
    return {to_mm, {}};
  }
  if (to_mm - from_mm < resolution_mm) return {from_mm, singular(*joints, from_mm)};
  const double half_mm = std::midpoint(from_mm, to_mm);
  LineEnd half = advance(line, from_mm, half_mm);
  return half.ended_by ? half : advance(line, half_mm, to_mm);
}

Failure ToolPath::singular(const arm::Joints& to, double way_mm) const {
  std::size_t fastest = 0;
  for (std::size_t axis = 0; axis < to.size(); ++axis) {
    if (std::abs(to[axis] - joints_[axis]) > std::abs(to[fastest] - joints_[fastest])) fastest = axis;
  }
  const Eigen::Vector3d at = point();
  return {"singular",
          fmt::format("axis {} would have to jump {:.2f} mm along the line, at ({:.1f} {:.1f} {:.1f}), to keep the arm "
                      "on it",
                      fastest + 1, way_mm, at.x(), at.y(), at.z()),
          to_datum(fastest + 1),
          {}};
}

double ToolPath::advance_as_far_as_it_can(const Line& line, double from_mm, double to_mm) {
  const std::size_t waypoints = waypoints_.size();
  const arm::Joints joints = joints_;
  const arm::ToolPose pose = pose_;
  double near_mm = from_mm;
  while (to_mm - near_mm > resolution_mm / 2) {
    const double middle_mm = std::midpoint(near_mm, to_mm);
    const LineEnd tried = advance(line, from_mm, middle_mm);
    (tried.ended_by ? to_mm : near_mm) = middle_mm;
    waypoints_.resize(waypoints);
    joints_ = joints;
    pose_ = pose;
  }
  if (near_mm - from_mm < resolution_mm) return from_mm;
  return advance(line, from_mm, near_mm).length_mm;
}

LineEnd ToolPath::line_by(const Eigen::Vector3d& offset_mm) {
  const double length_mm = offset_mm.norm();
  if (!(length_mm > 0)) return {0, {}};
  const Line line{point(), offset_mm / length_mm};
  const double steps = std::ceil(length_mm / step_mm);
  double good_mm = 0;
  for (double step = 1; step <= steps; ++step) {
    const double far_mm = length_mm * step / steps;
    const LineEnd end = advance(line, good_mm, far_mm);
    if (end.ended_by) return {advance_as_far_as_it_can(line, end.length_mm, far_mm), end.ended_by};
    good_mm = far_mm;
  }
  return {length_mm, {}};
}

Result<void> ToolPath::reach_by_line(const Eigen::Vector3d& point_mm) {
  const Eigen::Vector3d way_mm = point_mm - point();
  for (Eigen::Index i = 0; i < 3; ++i) {
    // Written so that a distance that is not finite is refused too.
    if (std::abs(way_mm[i]) < 10'000) continue;
    return fail("unreachable", fmt::format("the point's {} is over 10 m away", "xyz"[i]));
  }
  const LineEnd end = line_to(point_mm);
  if (end.ended_by) return fail(*end.ended_by);
  return {};
}

Result<void> ToolPath::joints_to(const arm::Joints& joints) {
  const Result<void> within = arm::check_limits(model_, joints);
  if (!within) return within;
  if (waypoints_.size() >= max_waypoints) {
    return fail("too-long", fmt::format("a motion has at most {} waypoints", max_waypoints));
  }
  waypoints_.push_back(joints);
  joints_ = joints;
  pose_ = arm::forward(model_, joints);
  return {};
}

}  // namespace pizarra::robot
