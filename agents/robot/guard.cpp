#include "agents/robot/guard.hpp"

#include <cmath>
#include <fmt/format.h>

#include "drivers/arm/kinematics.hpp"
#include "drivers/arm/move_check.hpp"

namespace pizarra::robot {

namespace {

std::optional<Failure> failure(std::string symbol, std::string sentence, Datum subject) {
  return Failure{std::move(symbol), std::move(sentence), std::move(subject), {}};
}

}  // namespace

std::optional<Failure> Guard::look(Time at, const arm::ArmReading& reading) {
  const Result<void> within = arm::check_reading(model_, reading.joints);
  if (!within) return within.error();
  if (const std::optional<Failure> fast = look_at_speed(at, reading.joints)) return fast;
  if (!room_) return {};
  const Eigen::Vector3d point = arm::forward(model_, reading.joints).translation();
  const bool inside = room_->holds(point);
  was_in_room_ = was_in_room_ || inside;
  if (inside || !was_in_room_) return {};
  return failure("out-of-room",
                 fmt::format("the grip centre is at ({:.0f} {:.0f} {:.0f}), out of the arm's room", point.x(),
                             point.y(), point.z()),
                 list("point"_sym, point.x(), point.y(), point.z()));
}

std::optional<Failure> Guard::look_at_speed(Time at, const arm::Joints& joints) {
  const Duration between = at - measured_at_;
  if (measured_.size() == joints.size() && between < speed_window) return {};
  const arm::Joints before = measured_;
  measured_ = joints;
  measured_at_ = at;
  // After a pause there is nothing to compare with.
  if (before.size() != joints.size() || between > 2 * speed_window) return {};
  const double seconds = std::chrono::duration<double>(between).count();
  for (std::size_t axis = 0; axis < joints.size(); ++axis) {
    const double speed = std::abs(joints[axis] - before[axis]) / seconds;
    if (speed <= speed_slack * model_.axes[axis].speed) continue;
    return failure(
        "too-fast",
        fmt::format("axis {} moves at {:.0f} a second, and may at {:g}", axis + 1, speed, model_.axes[axis].speed),
        to_datum(axis + 1));
  }
  return {};
}

}  // namespace pizarra::robot
