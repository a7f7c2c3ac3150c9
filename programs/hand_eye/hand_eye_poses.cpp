#include "programs/hand_eye/hand_eye_poses.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lisp/numbers.hpp"
#include "programs/hand_eye/spread_out.hpp"

namespace pizarra::hand_eye {

namespace {

constexpr double grid_mm = 40;
constexpr double yaws_deg[] = {-30, 0, 30};
constexpr double tilts_deg[] = {0, 12};
// A turn by so many degrees is worth as much as a millimetre.
constexpr double mm_per_degree = 4;

Eigen::Isometry3d tool_at(const CarriedPose& pose) {
  Eigen::Isometry3d tool = Eigen::Isometry3d::Identity();
  tool.linear() = (Eigen::AngleAxisd(radians(pose.yaw_deg), Eigen::Vector3d::UnitZ()) *
                   Eigen::AngleAxisd(radians(-pose.tilt_deg), Eigen::Vector3d::UnitY()) *
                   Eigen::AngleAxisd(std::numbers::pi, Eigen::Vector3d::UnitX()))
                      .toRotationMatrix();
  tool.translation() = pose.grip_mm;
  return tool;
}

double apart(const CarriedPose& one, const CarriedPose& other) {
  const double turned = std::hypot(one.yaw_deg - other.yaw_deg, one.tilt_deg - other.tilt_deg);
  return std::hypot((one.grip_mm - other.grip_mm).norm(), mm_per_degree * turned);
}

std::vector<CarriedPose> possible(const arm::ArmModel& arm, const coordinator::CameraView& view,
                                  const Eigen::Vector3d& mark_mm, const CarryingRoom& room, double margin_mm) {
  std::vector<CarriedPose> poses;
  const auto consider = [&](const CarriedPose& pose) {
    const Eigen::Isometry3d tool = tool_at(pose);
    if (view.shows(tool * mark_mm, margin_mm) && arm::inverse(arm, tool, arm.ready)) poses.push_back(pose);
  };
  for (double x = room.low_mm.x(); x <= room.high_mm.x(); x += grid_mm) {
    for (double y = room.low_mm.y(); y <= room.high_mm.y(); y += grid_mm) {
      for (double z = room.low_mm.z(); z <= room.high_mm.z(); z += grid_mm) {
        for (const double yaw : yaws_deg) {
          for (const double tilt : tilts_deg) consider({{x, y, z}, yaw, tilt});
        }
      }
    }
  }
  return poses;
}

}  // namespace

std::vector<CarriedPose> poses_to_carry_to(const arm::ArmModel& arm, const coordinator::CameraView& view,
                                           const Eigen::Vector3d& mark_mm, const CarryingRoom& room, double margin_mm,
                                           std::size_t wanted) {
  std::vector<CarriedPose> left = spread_out(possible(arm, view, mark_mm, room, margin_mm), wanted, apart);
  std::vector<CarriedPose> ordered;
  while (!left.empty()) {
    const auto nearest =
        ordered.empty()
            ? left.begin()
            : std::ranges::min_element(left, {}, [&](const CarriedPose& pose) { return apart(pose, ordered.back()); });
    ordered.push_back(*nearest);
    left.erase(nearest);
  }
  return ordered;
}

}  // namespace pizarra::hand_eye
