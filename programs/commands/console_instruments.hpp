#pragma once

// What a console measures of its board with the means of `top` and `method`, and what it lays over the cell of the
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
