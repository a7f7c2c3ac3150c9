#include "drivers/simulation/physics/arm_motion.hpp"

#include <algorithm>
#include <cmath>

#include "drivers/arm/kinematics.hpp"

namespace pizarra::simulation {

namespace {

constexpr double ramp_s = 0.25;  // to an axis' full speed

Result<void> check_path(const arm::ArmModel& model, const std::vector<arm::Joints>& waypoints, double speed) {
  if (waypoints.empty() || waypoints.size() > ArmMotion::max_waypoints) {
    return fail("bad-request", "a move has 1 to 10000 waypoints", to_datum(waypoints.size()));
  }
  if (!std::isfinite(speed)) return fail("not-finite", "the speed is not a number");
  if (speed <= 0 || speed > 1) return fail("bad-request", "a speed is above 0 and at most 1", to_datum(speed));
  for (const arm::Joints& joints : waypoints) {
    if (!std::ranges::all_of(joints, [](double angle) { return std::isfinite(angle); })) {
      return fail("not-finite", "a joint angle is not a number");
    }
    const Result<void> within = arm::check_limits(model, joints);
    if (!within) return within;
  }
  return {};
}

}  // namespace

Result<void> ArmMotion::start(std::vector<arm::Joints> waypoints, double speed) {
  if (moving_) return fail("busy", "the arm is moving already");
  const Result<void> sound = check_path(model_, waypoints, speed);
  if (!sound) return sound;
  path_ = std::move(waypoints);
  path_.insert(path_.begin(), joints_);
  times_s_.assign(1, 0.0);
  for (std::size_t i = 1; i < path_.size(); ++i) {
    double longest_s = 0;
    for (std::size_t axis = 0; axis < joints_.size(); ++axis) {
      const double way = std::abs(path_[i][axis] - path_[i - 1][axis]);
      longest_s = std::max(longest_s, way / (model_.axes[axis].speed * speed));
    }
    times_s_.push_back(times_s_.back() + longest_s);
  }
  along_s_ = 0;
  pace_ = 0;
  ramp_per_s_ = 1 / (ramp_s * speed);
  moving_ = true;
  braking_ = false;
  stopped_ = false;
  return {};
}

void ArmMotion::halt() {
  if (!moving_) return;
  moving_ = false;
  braking_ = false;
  stopped_ = true;
  pace_ = 0;
}

void ArmMotion::step(double seconds) {
  if (!moving_) return;
  const double left_s = std::max(0.0, times_s_.back() - along_s_);
  // The fastest pace from which the end can still be met.
  const double allowed = std::sqrt(2 * ramp_per_s_ * left_s);
  const double wanted = braking_ ? 0.0 : std::min(1.0, allowed);
  const double change = ramp_per_s_ * seconds;
  pace_ = std::clamp(wanted, pace_ - change, pace_ + change);
  along_s_ += pace_ * seconds;
  // The last hair is taken at once: the pace falls with the square root of what is left and would never get there.
  const bool arrived = along_s_ + change * seconds >= times_s_.back();
  if (arrived) along_s_ = times_s_.back();
  follow();
  if (braking_ && pace_ <= 0) {
    halt();
  } else if (arrived) {
    moving_ = false;
    stopped_ = braking_;
    braking_ = false;
    pace_ = 0;
  }
}

void ArmMotion::follow() {
  const auto after = std::ranges::upper_bound(times_s_, along_s_);
  if (after == times_s_.end()) {
    joints_ = path_.back();
    return;
  }
  const auto next = static_cast<std::size_t>(after - times_s_.begin());
  const double part = (along_s_ - times_s_[next - 1]) / (times_s_[next] - times_s_[next - 1]);
  for (std::size_t axis = 0; axis < joints_.size(); ++axis) {
    joints_[axis] = std::lerp(path_[next - 1][axis], path_[next][axis], part);
  }
}

}  // namespace pizarra::simulation
