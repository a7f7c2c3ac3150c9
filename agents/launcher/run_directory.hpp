#pragma once

// Where a running cell keeps its sockets, logs (process_log.hpp) and state, so that `ps`, `down` and the words that
// talk to a board find it: $XDG_RUNTIME_DIR/pizarra/CELL@HOST, or /tmp/pizarra-UID/CELL@HOST. It is the user's alone
// (mode 0700).
//
//   Result<RunDirectory> run = RunDirectory::make("blocks", "localhost");
//   run->save(state);
//   Result<RunState> running = find_run("");        // the only one that runs
//
// Whoever made it holds a lock on it for as long as it exists; the system lets go of that when the process ends,
// however it ends, so that what a dead one left is never taken for a running cell.

#include <memory>
#include <string>
#include <vector>

#include "lisp/result.hpp"

namespace pizarra::launcher {

struct RunProcess {
  std::string name;
  int pid = 0;
  int restarts = 0;
};

// The state file: (run "CELL" "HOST" SUPERVISOR-PID "BOARD-ADDRESS" "WORLD-ADDRESS" "KEY" "CELL-FILE"
// (process NAME PID RESTARTS) ...)
struct RunState {
  std::string cell;
  std::string host;
  int supervisor_pid = 0;
  std::string board_address;
  std::string world_address;
  std::string key;        // the file of the secret key with which one comes to the board; empty: none is needed
  std::string cell_file;  // its whole path
  std::vector<RunProcess> processes;
};

Datum run_state_to_datum(const RunState& state);
Result<RunState> run_state_from_datum(const Datum& datum);

class RunDirectory {
 public:
  // Begun anew: nothing of an earlier run is left but its journal. Failures: cannot-write, already-running.
  static Result<RunDirectory> make(const std::string& cell, const std::string& host);
  std::string file(const std::string& name) const { return path_ + "/" + name; }
  const std::string& path() const { return path_; }
  // Replaces the state as a whole.
  Result<void> save(const RunState& state) const;
  void remove_state() const;

 private:
  RunDirectory(std::string path, std::shared_ptr<const int> lock) : path_(std::move(path)), lock_(std::move(lock)) {}
  std::string path_;
  std::shared_ptr<const int> lock_;  // the file that is locked, closed with the last copy
};

// A file of that run.
std::string file_of(const RunState& run, const std::string& name);
// Whether the supervisor that said this state lives.
bool still_runs(const RunState& state);
// Every cell of this user whose supervisor lives.
std::vector<RunState> running_cells();
// The one of that cell's name, or the only one. Failures: nothing-runs, which-cell.
Result<RunState> find_run(const std::string& cell);

}  // namespace pizarra::launcher
