#pragma once

// The launcher's part in the names of a cell: it binds the agents that it keeps running by name and kind, in a context
// of its host:
//
//   (bound (cell hosts arm-pc) robot robot robot)
//
//   co_await bind_processes(board, "arm-pc", supervisor.processes(), lease);     // again and again
//
// An agent is bound once it is present on this host. Its name stays bound while its process is started again, and is
// unbound when that has ended for good. With the lease all of them go.

#include <string>
#include <vector>

#include "agents/launcher/supervisor.hpp"
#include "blackboard/board.hpp"

namespace pizarra::launcher {

// A name that this client may not bind stays unbound. What stands already is told for nothing.
Task<void> bind_processes(Board& board, std::string host, std::vector<Supervisor::Process> processes, LeaseId lease);

}  // namespace pizarra::launcher
