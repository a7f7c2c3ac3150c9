#pragma once

// `up` tells of the host that it runs on, for `hosts` to show: `(host NAME VERSION OFFSET-MS)`, under a lease. The
// offset is how far this machine's wall clock is ahead of the board's clock.
//
//   const Job told = executor.spawn(tell_host(board, executor, "arm-pc"));        // until it is destroyed

#include <string>

#include "blackboard/client/remote_board.hpp"

namespace pizarra::programs {

Relation host_relation();

Task<void> tell_host(client::RemoteBoard& board, Executor& executor, std::string host);

}  // namespace pizarra::programs
