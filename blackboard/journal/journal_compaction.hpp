#pragma once

// Moves a journal's horizon on: the oldest groups of the log become part of what stood at the horizon.
//
//   while (*advance_horizon(database, before_revision, before_time, slice_bytes) > 0) {}      // all that may go

#include "blackboard/journal/journal_file.hpp"

namespace pizarra::journal::journal_tables {

// One slice of the groups that ended before both, of about so many bytes: how many bytes of them are gone from the log,
// 0 when there are none.
Result<std::size_t> advance_horizon(sqlite::Database& database, Revision before_revision, Time before_time,
                                    std::size_t slice_bytes);
// A new file's horizon: what is durable in a store, as of a moment.
Result<void> begin_at(sqlite::Database& database, const store::Store& store, const LineStart& end);

}  // namespace pizarra::journal::journal_tables
