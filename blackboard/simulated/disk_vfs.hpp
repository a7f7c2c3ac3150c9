#pragma once

// The file system by which SQLite uses a SimulatedDisk.
//
//   sqlite3_vfs vfs = vfs_of(disk, name);
//   sqlite3_vfs_register(&vfs, 0);

#include <sqlite3.h>

#include "blackboard/simulated/simulated_disk.hpp"

namespace pizarra::simulated {

// Both outlive it.
sqlite3_vfs vfs_of(SimulatedDisk& disk, const char* name);

}  // namespace pizarra::simulated
