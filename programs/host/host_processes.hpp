#pragma once

// Which processes a host of a cell runs, each with its command line, in the order in which they are started.
//
//   Result<std::vector<HostProcess>> processes = host_processes(choices, cell, host, places, directory);
//   for (const HostProcess& process : *processes) start(process.name, process.command);

#include <string>
#include <vector>

#include "programs/host/host_places.hpp"

namespace pizarra::host {

struct HostProcess {
  std::string name;
  std::vector<std::string> command;
  int niceness = 0;
};

// Failures: those of the address of the cell's log, and of check_member and prepare_member.
Result<std::vector<HostProcess>> host_processes(const UpChoices& choices, const forms::CellDescription& cell,
                                                const forms::CellHost& host, const HostPlaces& places,
                                                const launcher::RunDirectory& directory);

// The console, which writes its addresses to one file and keeps pictures in a folder.
HostProcess console_process(const UpChoices& choices, const HostPlaces& places, const std::string& addresses,
                            const std::string& pictures);

}  // namespace pizarra::host
