#pragma once

// SQLite's log, written with nothing beforehand as far as it grows between two copyings: what is then written over is
// on the disk in half the time that a file takes which grows.
//
//   write_log_ahead(disk, "cell.journal-wal");     // once its database is open, before it writes anything more
//
// SQLite ignores bytes behind the last of its pages.

#include <string>

#include "blackboard/journal/disk.hpp"

namespace pizarra::journal {

// Where the disk is small nothing is done.
void write_log_ahead(Disk& disk, const std::string& path);

}  // namespace pizarra::journal
