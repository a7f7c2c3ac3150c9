#pragma once

// The tables of a journal's SQLite file, and how they become a store again.
//
//   about(name, value)               horizon (a revision), horizon-time, next-fact, facts (their sums' lower halves
//                                    added up), forgotten (the last number of the log that is gone); and sum, over the
//                                    rest of `about` and all of `relations`: the head
//   relations(name, form)            declared at the horizon
//   facts(id, taken, form, sum)      at the horizon, as on the wire: standing (0), taken (1), and the same of what was
//                                    told under a lease (2, 3)
//   log(number, revision, time, lines, replies, sum)     what came since, a group a row, numbered without a gap
//
// Elsewhere `sum` is a checksum of its row: SQLite has none of its own. A file of format 1 has none over its head, one
// of format 2 no `facts` and `forgotten`: it is believed when it is opened, and has them from its next opening to write
// on. Up to format 3 the sum of a group was another one, which its former groups keep.

#include <vector>

#include "blackboard/journal/journal_file.hpp"

namespace pizarra::journal::journal_tables {

// Another program that reads the file, as long as that takes at most.
constexpr const char* wait_for_others = "PRAGMA busy_timeout = 2000";
// Makes them where there are none. Failure bad-journal when it is some other file.
Result<sqlite::Database> open(const Disk& disk, const std::string& path, sqlite::Access access);

// A row's share in the sum that `about` keeps over all `facts`, so that a lost row is noticed.
constexpr std::int64_t added_to_facts(std::int64_t sum_of_fact) { return sum_of_fact & 0xffffffff; }
std::int64_t sum_of_fact(FactId id, store::Restored state, std::string_view form);
// Failure bad-journal.
Result<Fact> fact_from_row(FactId id, store::Restored state, std::string_view form, std::int64_t sum);
std::int64_t sum_of_group(std::int64_t number, std::string_view lines, std::string_view replies);
std::int64_t former_sum_of_group(std::int64_t number, std::string_view lines, std::string_view replies);
// One or the other.
bool is_sum_of_group(std::int64_t sum, std::int64_t number, std::string_view lines, std::string_view replies);

// Whether the head is as it was written.
Result<void> check_head(sqlite::Database& database);
// Sums it up anew, in the transaction that changed it.
Result<void> seal_head(sqlite::Database& database);

Result<std::int64_t> about(sqlite::Database& database, std::string_view name);
Result<void> set_about(sqlite::Database& database, std::string_view name, std::int64_t value);

// Up to a moment, into an empty store. Failures bad-journal and forgotten.
Result<PlayedBack> restore(sqlite::Database& database, store::Store& store, const Moment& until);
// Of the last `length` before the last group, newest 256 of a session.
Result<std::vector<RememberedReply>> remembered(sqlite::Database& database, Duration length);

// What SQLite says, in a journal's words.
Failure failure_of(const Failure& failure, const std::string& path);

}  // namespace pizarra::journal::journal_tables
