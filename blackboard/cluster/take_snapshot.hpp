#pragma once

// Keeps a cell's log in a cluster short: a snapshot takes the place of the entries that it has.
//
//   Result<std::size_t> bytes = take_snapshot(key_values, LogKeys("blocks"), nonce);

#include "blackboard/cluster/log_keys.hpp"

namespace pizarra::cluster {

// Writes a snapshot of all that the log has by now and deletes the entries before it. Any board may do so at any time.
// Answers how many bytes it has; 0 where there was nothing to do, or another board was faster. `nonce`: no other board
// has the same. Failures: FollowedLog's.
Result<std::size_t> take_snapshot(KeyValues& key_values, const LogKeys& keys, std::uint64_t nonce);

}  // namespace pizarra::cluster
