#include "drivers/simulation/controllers/ptu_settings.hpp"

namespace pizarra::simulation {

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
