#pragma once

// Where a host of a cell finds the cell's board and its world, and with which keys.
//
//   Result<HostPlaces> places = host_places(choices, cell, host, directory);
//   client::keyed_board(executor, places->board, places->key, "narrator");

#include <string>

#include "agents/launcher/run_directory.hpp"
#include "lisp/forms/cell_file.hpp"
#include "programs/host/up_choices.hpp"

namespace pizarra::host {

struct HostPlaces {
  bool owns_board = false;  // the cell's board runs here
  std::string board;        // its address; those of all, where boards take over from each other
  std::string world;        // the address of the simulated world
  std::string keys;         // the folder of those that may come to this host's board; empty: it asks for none
  std::string key;          // the file with which this host comes to the board; empty: it needs none
};

// Of a host's log and its board: failures bad-option, and those of LogAddress::from.
Result<void> check_log(const UpChoices& choices, const forms::CellDescription& cell, const forms::CellHost& host);

// Refuses options on keys that would have no effect; of a host with a log, what would keep its board from taking over.
// Failures: bad-option, and those of LogAddress::from and KeyFolder::open.
Result<void> check_options(const UpChoices& choices, const forms::CellDescription& cell, const forms::CellHost& host);

// Failure: no-world, where an agent needs the simulated world and that runs on no host of this machine.
Result<HostPlaces> host_places(const UpChoices& choices, const forms::CellDescription& cell,
                               const forms::CellHost& host, const launcher::RunDirectory& directory);

// Where an agent's device is, unless it is on a line of its own: its plug-in's process, or the world.
std::string device_address(const std::string& agent, const forms::CellDescription& cell, const HostPlaces& places,
                           const launcher::RunDirectory& directory);

std::string first_address(const std::string& addresses);

}  // namespace pizarra::host
