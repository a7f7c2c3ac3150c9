#include "agents/pan_tilt/gaze.hpp"

#include <cmath>

#include "drivers/ptu/head_axes.hpp"
#include "lisp/numbers.hpp"

namespace pizarra::pan_tilt {

Gaze gaze_at(const forms::CameraPose& mount, const std::array<double, 3>& point_mm) {
  constexpr int rounds = 30;
  const Eigen::Vector3d point = ptu::camera_frame(mount).inverse() * Eigen::Vector3d(point_mm.data());
  ptu::HeadTurn turn;
  for (int round = 0; round < rounds; ++round) {
    const Eigen::Vector3d seen = ptu::head_turn(mount, turn).inverse() * point;
    turn.pan_deg = std::remainder(turn.pan_deg + degrees(std::atan2(seen.x(), seen.z())), 360);
    turn.tilt_deg += degrees(std::atan2(-seen.y(), std::hypot(seen.x(), seen.z())));
  }
  return {turn.pan_deg, turn.tilt_deg};
}

}  // namespace pizarra::pan_tilt
