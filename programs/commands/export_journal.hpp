#pragma once

// A journal as a file for others' tools: what `replay --mcap` writes, with the channels that the console offers
// (agents/console/foxglove_channels.hpp).
//
//   Result<std::uint64_t> messages = export_journal(executor, {"cell.journal"}, {.revision = 1}, {}, "run.mcap");

#include <cstdint>
#include <string>

#include "blackboard/fact.hpp"
#include "blackboard/time/executor.hpp"
#include "lisp/result.hpp"
#include "programs/commands/kept_journal.hpp"

namespace pizarra::programs {

// From that moment to the journal's end; from its beginning where none is said; with what was seen meanwhile, as a
// console kept it in the folder `pictures`, if one is named. How many messages were written. Failures: those of reading
// a journal, and unwritable-file.
Result<std::uint64_t> export_journal(Executor& executor, const KeptJournal& journal, const Moment& from,
                                     const std::string& pictures, const std::string& file);

}  // namespace pizarra::programs
