#include "programs/hand_eye/hand_eye_poses.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "lisp/numbers.hpp"

namespace pizarra::hand_eye {

namespace {

constexpr double grid_mm = 40;
constexpr double yaws_deg[] = {-30, 0, 30};
constexpr double tilts_deg[] = {0, 12};
// A turn by so many degrees is worth as much as a millimetre.
constexpr double mm_per_degree = 4;

// Of a head's angles.
constexpr double grid_deg = 2;
constexpr double most_pan_deg = 40;
constexpr double most_tilt_deg = 30;
constexpr double least_turn_deg = 4;

// A few of many things, far apart from one another: each the farthest from those chosen before it.
template <class Thing, class Apart>
std::vector<Thing> spread_out(const std::vector<Thing>& things, std::size_t wanted, const Apart& apart) {
  std::vector<Thing> chosen;
  std::vector<double> nearest(things.size(), std::numeric_limits<double>::infinity());
  std::size_t next = 0;
  while (chosen.size() < std::min(wanted, things.size())) {
    chosen.push_back(things[next]);
    for (std::size_t i = 0; i < things.size(); ++i) nearest[i] = std::min(nearest[i], apart(things[i], things[next]));
    next = static_cast<std::size_t>(std::ranges::max_element(nearest) - nearest.begin());
  }
  return chosen;
}

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

double turned_apart(ptu::HeadTurn one, ptu::HeadTurn other) {
  return std::hypot(one.pan_deg - other.pan_deg, one.tilt_deg - other.tilt_deg);
}

bool reaches(const ptu::PanTiltAxisRange& axis, double deg) { return axis.low_deg <= deg && deg <= axis.high_deg; }

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

std::vector<ptu::HeadTurn> angles_to_turn_to(const forms::CameraPose& pose, const coordinator::CameraModel& model,
                                             const Eigen::Vector3d& mark_mm, const ptu::PanTiltRange& range,
                                             double margin_mm, std::size_t wanted) {
  std::vector<ptu::HeadTurn> possible;
  for (double pan = -most_pan_deg; pan <= most_pan_deg; pan += grid_deg) {
    for (double tilt = -most_tilt_deg; tilt <= most_tilt_deg; tilt += grid_deg) {
      const ptu::HeadTurn turn{pan, tilt};
      const bool within =
          reaches(range.pan, pan) && reaches(range.tilt, tilt) && turned_apart(turn, {}) >= least_turn_deg;
      if (within && coordinator::CameraView(pose, model, turn).shows(mark_mm, margin_mm)) possible.push_back(turn);
    }
  }
  return spread_out(possible, wanted, turned_apart);
}

}  // namespace pizarra::hand_eye
