#include "drivers/simulation/controllers/arms/ur_power.hpp"

#include "drivers/arm/universal/rtde.hpp"

namespace pizarra::simulation {

std::int32_t UrPower::mode() const {
  if (cabinet_.servo()) return arm::rtde::running_mode;
  return energized_ && !cabinet_.emergency() ? idle_mode : off_mode;
}

void UrPower::off() {
  energized_ = false;
  static_cast<void>(cabinet_.servo(false));
}

void UrPower::release_brakes() {
  energized_ = true;
  static_cast<void>(cabinet_.servo(true));
}

}  // namespace pizarra::simulation
