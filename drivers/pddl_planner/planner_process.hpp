#pragma once

// A foreign program run to its end in a process group of its own, under limits: whatever happens, nothing of it is left
// running, nor of what it started (process_keeper.hpp).
//
//   const ProcessEnd end = run_process("ff -o d.pddl -f p.pddl", "/tmp/run", ProcessLimits{}, [] { return false; });
//   if (end.kind == ProcessEnd::Kind::exited && end.code == 0) read(end.output);

#include <cstdint>
#include <functional>
#include <string>

namespace pizarra::pddl_planner {

struct ProcessLimits {
  double seconds = 300;                   // of wall time; of processor time a little more
  std::size_t memory_bytes = 4ULL << 30;  // of address space, each process
  std::size_t output_bytes = 16 << 20;    // that it may print, and that its plan may have
  std::size_t file_bytes = 256ULL << 20;  // each file that it may write
};

struct ProcessEnd {
  enum class Kind : std::uint8_t { exited, signalled, timed_out, cancelled, too_much_output, not_started };
  Kind kind = Kind::not_started;
  int code = 0;        // the exit status, or the signal's number
  std::string output;  // what it printed, errors among it
};

// Runs the shell's command in the folder, with nothing to read. `cancelled` is asked some fifty times a second.
ProcessEnd run_process(const std::string& command, const std::string& folder, const ProcessLimits& limits,
                       const std::function<bool()>& cancelled);

}  // namespace pizarra::pddl_planner
