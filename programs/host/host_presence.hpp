#pragma once

// `up` tells of the host that it runs on, for `hosts` to show: `(host NAME VERSION OFFSET-MS)`, under a lease. The
// offset is how far this machine's wall clock is ahead of the board's clock. Under the same lease it tells of the
// processes that it keeps running: `(process HOST NAME RUNNING RESTARTS NEWEST)`, and binds their agents
// (agents/launcher/host_names.hpp).
//
//   const Job told = executor.spawn(tell_host(board, executor, "arm-pc", processes));   // until it is destroyed

#include <functional>
#include <string>
#include <vector>

#include "agents/launcher/supervisor.hpp"
#include "blackboard/client/remote_board.hpp"

namespace pizarra::host {

Relation host_relation();

using Processes = std::function<std::vector<launcher::Supervisor::Process>()>;
Task<void> tell_host(client::RemoteBoard& board, Executor& executor, std::string host, Processes processes);

}  // namespace pizarra::host
