#include "drivers/simulation/controllers/ptu_settings.hpp"

#include <limits>

namespace pizarra::simulation {

int PtuUnit::low(const PtuChannel& channel) const {
  if (!modes.limits) return std::numeric_limits<int>::min();
  return modes.user_limits ? channel.user_low : channel.axis.model().low;
}

int PtuUnit::high(const PtuChannel& channel) const {
  if (!modes.limits) return std::numeric_limits<int>::max();
  return modes.user_limits ? channel.user_high : channel.axis.model().high;
}

void PtuUnit::advance(Duration time) {
  pan.axis.advance(time);
  tilt.axis.advance(time);
}

void PtuUnit::save() { saved_ = {modes, pan.axis.speeds(), tilt.axis.speeds()}; }

void PtuUnit::restore() {
  modes = saved_.modes;
  pan.axis.speeds() = saved_.pan;
  tilt.axis.speeds() = saved_.tilt;
}

void PtuUnit::restore_factory() {
  modes = PtuModes();
  pan.axis.speeds() = model->speeds;
  tilt.axis.speeds() = model->speeds;
}

}  // namespace pizarra::simulation
