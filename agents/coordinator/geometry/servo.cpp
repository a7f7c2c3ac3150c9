#include "agents/coordinator/geometry/servo.hpp"

#include <algorithm>
#include <cmath>

namespace pizarra::coordinator {

namespace {

using Motion = ServoCommand::Motion;

// Of a way, where hardly any of it was gone.
constexpr double part_left = 0.8;

ServoCommand fine_command(const ServoErrors& errors) {
  if (std::abs(errors.across_mm) > ServoLimits::turn_mm)
    return {4, Motion::turn, ServoLimits::fine_gain * errors.bearing_deg};
  if (std::abs(errors.across_mm) > ServoLimits::fine_mm)
    return {4, Motion::move_h, ServoLimits::fine_gain * errors.across_mm};
  if (std::abs(errors.along_mm) > ServoLimits::fine_mm)
    return {4, Motion::extend, ServoLimits::fine_gain * errors.along_mm};
  if (errors.down_mm > ServoLimits::done_mm)
    return {4, Motion::down, std::min(errors.down_mm, ServoLimits::fine_step_mm)};
  if (errors.down_mm < -2 * ServoLimits::done_mm) return {4, Motion::up, -errors.down_mm};
  return {4, Motion::done, 0};
}

}  // namespace

bool has_stalled(const ServoCommand& command, const ServoCommand& before) {
  const bool sideways =
      command.motion == Motion::turn || command.motion == Motion::extend || command.motion == Motion::move_h;
  if (!sideways || command.motion != before.motion || command.amount * before.amount < 0) return false;
  return std::abs(command.amount) > part_left * std::abs(before.amount);
}

ServoCommand servo_command(const ServoErrors& errors, bool descend) {
  const double sideways = std::max(std::abs(errors.across_mm), std::abs(errors.along_mm));
  const bool must_rise = descend ? sideways > ServoLimits::follow_mm : sideways > ServoLimits::coarse_mm;
  if (must_rise && errors.clearance_mm > ServoLimits::coarse_mm) return {0, Motion::up, errors.clearance_mm};
  const bool fine = descend && errors.down_mm <= ServoLimits::fine_zone_mm && sideways <= ServoLimits::follow_mm;
  if (fine) return fine_command(errors);
  if (std::abs(errors.across_mm) > ServoLimits::coarse_mm) return {1, Motion::turn, errors.bearing_deg};
  if (std::abs(errors.along_mm) > ServoLimits::coarse_mm) return {2, Motion::extend, errors.along_mm};
  if (!descend) return {2, Motion::done, 0};
  return {3, Motion::down,
          std::min(errors.down_mm - ServoLimits::fine_zone_mm + ServoLimits::coarse_mm, ServoLimits::step_mm)};
}

}  // namespace pizarra::coordinator
