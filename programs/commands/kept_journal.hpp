#pragma once

// Where a journal is kept, as a command line names it: a file, or a log in an etcd cluster, etcd://A,B,C/CELL.
//
//   KeptJournal journal;
//   add_kept_journal(command, journal, "A journal");
//   Result<std::unique_ptr<memory::RecordedBoard>> board = open_recorded(executor, journal, {.revision = 120});

#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "blackboard/cluster/key_values.hpp"
#include "blackboard/cluster/log_keys.hpp"
#include "blackboard/memory/recorded_board.hpp"

namespace pizarra::programs {

struct KeptJournal {
  std::string where;
  std::string certificates;
  bool insecure = false;
};

// The argument and the options of a log.
void add_kept_journal(CLI::App& command, KeptJournal& journal, const std::string& help);
void add_log_options(CLI::App& command, std::string& certificates, bool& insecure);

// Failures of reading a journal, and those of a log: bad-address, not-loopback, unavailable.
Result<journal::LineStart> end_of(const KeptJournal& journal);
Result<std::unique_ptr<memory::RecordedBoard>> open_recorded(Executor& executor, const KeptJournal& journal,
                                                             const Moment& until);

struct OpenLog {
  std::unique_ptr<cluster::KeyValues> key_values;
  cluster::LogKeys keys;
};
Result<OpenLog> open_log(const KeptJournal& journal);

}  // namespace pizarra::programs
