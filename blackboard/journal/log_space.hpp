#pragma once

// SQLite's log, written with nothing beforehand as far as it grows between two copyings: what is then written over is
// on the disk in half the time that a file takes which grows.
//
//   write_log_ahead("cell.journal-wal");     // once its database is open, before it writes anything more
//
// What SQLite finds behind the last of its pages is nothing to it.

#include <string>

namespace pizarra::journal {

// Where the disk is small nothing is done.
void write_log_ahead(const std::string& path);

}  // namespace pizarra::journal
