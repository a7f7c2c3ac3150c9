#include "agents/robot/tool_path.hpp"

#include <cmath>
#include <fmt/format.h>

namespace pizarra {

ToolPath::ToolPath(const ArmModel& model, const Joints& from, Track track)
    : model_(model), track_(track), joints_(from), pose_(forward(model, from)) {}

Result<Joints> ToolPath::reach(const Eigen::Vector3d& point_mm) const {
  if (waypoints_.size() >= max_waypoints) {
    return fail("too-long", fmt::format("a motion has at most {} waypoints", max_waypoints));
  }
  ToolPose pose = pose_;
  pose.translation() = point_mm;
  pose = nearest_attainable(model_, pose, joints_);
  const Result<Joints> joints =
      track_ == Track::stays ? inverse_in_place(model_, pose, joints_) : inverse(model_, pose, joints_);
  if (!joints) return joints;
  for (std::size_t axis = 0; axis < joints->size(); ++axis) {
    const double widest = slides(model_.axes[axis].role) ? posture_change_mm : posture_change_deg;
    if (std::abs((*joints)[axis] - joints_[axis]) <= widest) continue;
    return fail("joint-limit",
                fmt::format("axis {} would have to change its posture on the way to ({:.1f} {:.1f} {:.1f})", axis + 1,
                            point_mm.x(), point_mm.y(), point_mm.z()),
                to_datum(axis + 1));
  }
  return joints;
}

void ToolPath::append(const Joints& joints, const Eigen::Vector3d& point_mm) {
  waypoints_.push_back(joints);
  joints_ = joints;
  pose_.translation() = point_mm;
}

void ToolPath::append_straight(const Line& line, double from_mm, double to_mm, const Joints& joints) {
  Joints middle = joints;
  for (std::size_t axis = 0; axis < joints.size(); ++axis) middle[axis] = (joints_[axis] + joints[axis]) / 2;
  const Eigen::Vector3d off = forward(model_, middle).translation() - line.start_mm;
  const bool straight = (off - off.dot(line.along) * line.along).norm() <= deviation_mm;
  const double half_mm = (from_mm + to_mm) / 2;
  if (!straight && half_mm - from_mm > resolution_mm) {
    const Result<Joints> half = reach(line.at(half_mm));
    if (half) append_straight(line, from_mm, half_mm, *half);
    const Result<Joints> rest = half ? reach(line.at(to_mm)) : half;
    if (rest) return append_straight(line, half_mm, to_mm, *rest);
  }
  append(joints, line.at(to_mm));
}

LineEnd ToolPath::line_by(const Eigen::Vector3d& offset_mm) {
  const double length_mm = offset_mm.norm();
  if (!(length_mm > 0)) return {0, {}};
  const Eigen::Vector3d start = point();
  const Eigen::Vector3d along = offset_mm / length_mm;
  const double steps = std::ceil(length_mm / step_mm);
  double good_mm = 0;
  for (double step = 1; step <= steps; ++step) {
    double far_mm = length_mm * step / steps;
    const Result<Joints> joints = reach(start + along * far_mm);
    if (joints) {
      append_straight({start, along}, good_mm, far_mm, *joints);
      good_mm = far_mm;
      continue;
    }
    // The last piece ends between two waypoints.
    double near_mm = good_mm;
    std::optional<Joints> last;
    while (far_mm - near_mm > resolution_mm / 2) {
      const double middle_mm = (near_mm + far_mm) / 2;
      const Result<Joints> tried = reach(start + along * middle_mm);
      (tried ? near_mm : far_mm) = middle_mm;
      if (tried) last = *tried;
    }
    if (last && near_mm - good_mm >= resolution_mm) {
      append(*last, start + along * near_mm);
      good_mm = near_mm;
    }
    return {good_mm, joints.error()};
  }
  return {length_mm, {}};
}

Result<void> ToolPath::joints_to(const Joints& joints) {
  const Result<void> within = check_limits(model_, joints);
  if (!within) return within;
  if (waypoints_.size() >= max_waypoints) {
    return fail("too-long", fmt::format("a motion has at most {} waypoints", max_waypoints));
  }
  waypoints_.push_back(joints);
  joints_ = joints;
  pose_ = forward(model_, joints);
  return {};
}

}  // namespace pizarra
