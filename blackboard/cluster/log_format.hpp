#pragma once

// In which format a cell's log is written, so that no board of another version misreads it: `pizarra/CELL/format`. Who
// takes the lead puts it there. A log without it is of the first format, which did not say so.
//
//   const Result<void> readable = check_format(key_values, keys);
//
// A board reads its own format and the one before it, and writes its own. So hosts may be brought up to date one after
// another: newer boards follow an older one's log, and from when a newer one leads the older ones are refused.

#include "blackboard/cluster/log_keys.hpp"

namespace pizarra::cluster {

// Of this build.
inline constexpr std::uint64_t log_format = 2;

KeyValue format_of_this_build(const LogKeys& keys);
// Failures other-format, and unavailable.
Result<void> check_format(KeyValues& key_values, const LogKeys& keys);

}  // namespace pizarra::cluster
