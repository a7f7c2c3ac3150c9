#pragma once

// Orders to move, as the High Speed Ethernet Server takes them: to pulses of the axes, or to a pose of the tool.
//
//   const HsesOutcome outcome = co_await hses_move_pulses(controller, request);

#include "drivers/simulation/controllers/arms/hses_outcome.hpp"
#include "drivers/simulation/controllers/arms/motoman_controller.hpp"

namespace pizarra::simulation {

// The controller outlives them.
Task<HsesOutcome> hses_move_pulses(MotomanController& controller, arm::HsesRequest request);
Task<HsesOutcome> hses_move_cartesian(MotomanController& controller, arm::HsesRequest request);

}  // namespace pizarra::simulation
