#pragma once

// Whose log it is: `pizarra/CELL/cell` has the name of the cell whose board came first. A board of another cell would
// follow its facts, and take its lead.
//
//   const Result<void> mine = claim_log(key_values, keys, "blocks");    // also where it was claimed before

#include <string>

#include "blackboard/cluster/log_keys.hpp"

namespace pizarra::cluster {

// Failures other-cell, and unavailable.
Result<void> claim_log(KeyValues& key_values, const LogKeys& keys, const std::string& cell);

}  // namespace pizarra::cluster
