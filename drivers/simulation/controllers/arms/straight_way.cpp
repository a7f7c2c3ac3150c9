#include "drivers/simulation/controllers/arms/straight_way.hpp"

#include <algorithm>
#include <cmath>

#include "drivers/arm/route.hpp"

namespace pizarra::simulation {

namespace {

constexpr double step_mm = 2;
constexpr double step_rad = 0.02;
constexpr int most_steps = 5000;
constexpr double slowest = 1e-3;

}  // namespace

Result<StraightWay> straight_way(const arm::ArmModel& model, const arm::Joints& from, const arm::ToolPose& to,
                                 double mm_s) {
  const arm::ToolPose begin = arm::forward(model, from);
  const Eigen::Quaterniond turned(begin.linear());
  const Eigen::Quaterniond turning(to.linear());
  const double length_mm = (to.translation() - begin.translation()).norm();
  const double steps_needed = std::ceil(std::max(length_mm / step_mm, turned.angularDistance(turning) / step_rad));
  if (!(steps_needed <= most_steps)) return fail("unreachable", "the straight way is too long");
  const int steps = std::max(1, static_cast<int>(steps_needed));
  StraightWay way{{}, 1};
  double seconds = 0;
  arm::Joints at = from;
  for (int i = 1; i <= steps; ++i) {
    const double part = static_cast<double>(i) / steps;
    arm::ToolPose pose = begin;
    pose.translation() += part * (to.translation() - begin.translation());
    pose.linear() = turned.slerp(part, turning).toRotationMatrix();
    const Result<arm::Joints> joints = arm::inverse(model, pose, at);
    if (!joints) return fail(joints);
    seconds += arm::seconds_between(model, at, *joints);
    at = *joints;
    way.waypoints.push_back(at);
  }
  const double wanted_s = length_mm / std::max(mm_s, slowest);
  way.part = wanted_s > 0 ? std::clamp(seconds / wanted_s, slowest, 1.0) : 1.0;
  return way;
}

}  // namespace pizarra::simulation
