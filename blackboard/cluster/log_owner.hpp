#pragma once

// Whose log it is: `pizarra/CELL/cell` has the name of the cell whose board came first, and the key of its boards, by
// which two cells of one name differ. A board of another cell would follow its facts, and take its lead.
//
//   const Result<void> mine = claim_log(key_values, keys, {"blocks", public_key});
//
// A cell may claim its log again.

#include <string>

#include "blackboard/cluster/log_keys.hpp"

namespace pizarra::cluster {

struct LogOwner {
  std::string cell;
  std::string key = {};  // public; empty where its boards have none
};

// Failures other-cell, and unavailable.
Result<void> claim_log(KeyValues& key_values, const LogKeys& keys, const LogOwner& owner);

}  // namespace pizarra::cluster
