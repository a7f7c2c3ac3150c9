#pragma once

// A cell's durable facts, its counters and the replies that are remembered, from a journal in a file to a log in a
// cluster and back, while no board has either. What is copied to is new: a cell that the cluster knows, or a file that
// is there, is refused.
//
//   Result<Transferred> there = file_to_cluster("cell.journal", key_values, LogKeys("blocks"), nonce);
//   Result<Transferred> back = cluster_to_file(key_values, LogKeys("blocks"), "cell.journal", pause);
//
// The past is not copied. Failures: exists, in-use, unavailable, and those of the journal (journal_file.hpp).

#include <functional>

#include "blackboard/cluster/log_keys.hpp"

namespace pizarra::cluster {

struct Transferred {
  std::size_t facts = 0;
  Revision revision = 0;
};

Result<Transferred> file_to_cluster(const std::string& file, KeyValues& key_values, const LogKeys& keys,
                                    std::uint64_t nonce);
// Waits so long: meanwhile whoever leads says so in the log.
using Pause = std::function<void(Duration)>;
Result<Transferred> cluster_to_file(KeyValues& key_values, const LogKeys& keys, const std::string& file,
                                    const Pause& pause);

}  // namespace pizarra::cluster
