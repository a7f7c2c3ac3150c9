#pragma once

// The measurements of a board that a console shows, taken as `top` and `method` take them; and the truth of the
// simulated world.

#include <functional>
#include <string>

#include "agents/console/instruments.hpp"
#include "agents/console/truth_feed.hpp"
#include "blackboard/time/executor.hpp"
#include "drivers/simulation/link.hpp"

namespace pizarra::programs {

console::Instruments console_instruments(Executor& executor);
// With the cells that the board at `address` names, too; `secret_of` answers the file of a key's secret.
console::Instruments console_instruments(Executor& executor, std::string address,
                                         std::function<std::string(const std::string& key)> secret_of);
// The link outlives it.
console::TruthFeed::Ask truth_of_world(simulation::Link& link);

}  // namespace pizarra::programs
