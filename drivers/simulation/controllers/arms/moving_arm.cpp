#include "drivers/simulation/controllers/arms/moving_arm.hpp"

#include <algorithm>

namespace pizarra::simulation {

void MovingArm::catch_up() {
  constexpr double step_s = std::chrono::duration<double>(step_time).count();
  while (stepped_to_ + step_time <= executor_.now()) {
    const bool still = !motion_.moving() && opening_mm_ == wanted_mm_;
    if (still) {
      stepped_to_ = executor_.now();
      return;
    }
    stepped_to_ += step_time;
    motion_.step(step_s);
    const double step_mm = fingers_mm_s * step_s;
    opening_mm_ = std::clamp(wanted_mm_, opening_mm_ - step_mm, opening_mm_ + step_mm);
  }
}

Task<Result<std::string>> MovingArm::identify() { co_return model_.type; }

Task<Result<void>> MovingArm::take_control() { co_return Result<void>(); }

Task<Result<void>> MovingArm::start_move(std::vector<arm::Joints> waypoints, double speed) {
  catch_up();
  co_return motion_.start(std::move(waypoints), speed);
}

Task<Result<void>> MovingArm::stop() {
  catch_up();
  motion_.brake();
  co_return Result<void>();
}

Task<Result<void>> MovingArm::start_gripper(double opening_mm) {
  catch_up();
  wanted_mm_ = std::clamp(opening_mm, 0.0, widest_mm);
  co_return Result<void>();
}

Task<Result<arm::ArmReading>> MovingArm::read() {
  catch_up();
  arm::ArmReading reading{.joints = motion_.joints(),
                          .moving = motion_.moving(),
                          .stopped = motion_.stopped(),
                          .opening_mm = opening_mm_,
                          .gripper_moving = opening_mm_ != wanted_mm_};
  co_return reading;
}

}  // namespace pizarra::simulation
