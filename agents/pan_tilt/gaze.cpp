#include "agents/pan_tilt/gaze.hpp"

#include <cmath>
#include <numbers>

namespace pizarra::pan_tilt {

namespace {

constexpr double degrees = 180 / std::numbers::pi;

}  // namespace

Gaze gaze_at(const forms::CameraPose& mount, const std::array<double, 3>& point_mm) {
  const double x = point_mm[0] - mount.at_mm[0];
  const double y = point_mm[1] - mount.at_mm[1];
  const double z = point_mm[2] - mount.at_mm[2];
  const double pan = std::atan2(y, -x) * degrees - mount.pan_deg;
  return {std::remainder(pan, 360), std::atan2(z, std::hypot(x, y)) * degrees - mount.tilt_deg};
}

}  // namespace pizarra::pan_tilt
