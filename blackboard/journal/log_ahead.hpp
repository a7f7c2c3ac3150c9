#pragma once

// Fills SQLite's log with zeros beforehand, as far as it grows between two checkpoints. Writing over what is there is
// on the disk in half the time that a growing file takes.
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
