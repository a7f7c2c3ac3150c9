#include "agents/robot/tool_path.hpp"

#include <cmath>
#include <fmt/format.h>

namespace pizarra {

ToolPath::ToolPath(const ArmModel& model, const Joints& from)
    : model_(model), joints_(from), pose_(forward(model, from)) {}

Result<Joints> ToolPath::reach(const Eigen::Vector3d& point_mm) const {
  if (waypoints_.size() >= max_waypoints) {
    return fail("too-long", fmt::format("a motion has at most {} waypoints", max_waypoints));
  }
  ToolPose pose = pose_;
  pose.translation() = point_mm;
  const Result<Joints> joints = inverse(model_, pose, joints_);
  if (!joints) return joints;
  for (std::size_t axis = 0; axis < arm_axes; ++axis) {
    if (std::abs((*joints)[axis] - joints_[axis]) <= posture_change_deg) continue;
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
      append(*joints, start + along * far_mm);
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
