#pragma once

// Moves a journal's horizon on: the oldest groups of the log become part of what stood at the horizon.

#include "blackboard/journal/journal_file.hpp"

namespace pizarra::journal_tables {

// One slice of the groups that ended before both; whether there may be more.
Result<bool> advance_horizon(sqlite::Database& database, Revision before_revision, Time before_time);

}  // namespace pizarra::journal_tables
