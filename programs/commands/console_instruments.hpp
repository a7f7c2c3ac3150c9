#pragma once

// The measurements of a board that a console shows, taken as `top` and `method` take them; and the truth of the
// simulated world.

#include "agents/console/instruments.hpp"
#include "agents/console/truth_feed.hpp"
#include "blackboard/time/executor.hpp"
#include "drivers/simulation/link.hpp"

namespace pizarra::programs {

console::Instruments console_instruments(Executor& executor);
// The link outlives it.
console::TruthFeed::Ask truth_of_world(simulation::Link& link);

}  // namespace pizarra::programs
