#pragma once

// An etcd member of a cell's log on this host, as a process: its command line. Started again with the same folder it is
// the same member.
//
//   Result<std::vector<std::string>> command = log_member(*address, "10.0.0.1", "/var/lib/pizarra/blocks");
//
// Members speak to one another at the port above the one at which they are asked. With certificates both ways are
// encrypted, by server.crt and server.key, to whom ca.crt vouches for.

#include <string>
#include <vector>

#include "blackboard/cluster/log_address.hpp"

namespace pizarra::programs {

// `here`: which of the log's members it is. Failures bad-address, and no-program where etcd is not installed.
Result<std::vector<std::string>> log_member(const cluster::LogAddress& log, const std::string& here,
                                            const std::string& folder);

}  // namespace pizarra::programs
