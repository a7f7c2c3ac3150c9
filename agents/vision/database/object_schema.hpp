#pragma once

// The table in the object database, and how one that an earlier version of this program made becomes one of ours.
//
//   Result<void> prepared = prepare_objects(database);         // also a new, empty file
//   Result<void> prepared = prepare_objects_again(database);   // one that has been prepared before
//
// Failure `unusable` where the file is no database that this version knows. All or nothing; twice is harmless.

#include "blackboard/journal/sqlite.hpp"

namespace pizarra::vision {

Result<void> prepare_objects(journal::sqlite::Database& database);
// Failure `damaged` where it is none of ours: a copy that is still being made is none yet.
Result<void> prepare_objects_again(journal::sqlite::Database& database);

}  // namespace pizarra::vision
