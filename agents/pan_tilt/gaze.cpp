#include "agents/pan_tilt/gaze.hpp"

#include <cmath>

#include "lisp/numbers.hpp"

namespace pizarra::pan_tilt {

Gaze gaze_at(const forms::CameraPose& mount, const std::array<double, 3>& point_mm) {
  const double x = point_mm[0] - mount.at_mm[0];
  const double y = point_mm[1] - mount.at_mm[1];
  const double z = point_mm[2] - mount.at_mm[2];
  const double pan = degrees(std::atan2(y, -x)) - mount.pan_deg;
  return {std::remainder(pan, 360), degrees(std::atan2(z, std::hypot(x, y))) - mount.tilt_deg};
}

}  // namespace pizarra::pan_tilt
