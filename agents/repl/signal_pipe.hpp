#pragma once

// Signals as something to read, whichever thread of the process they came to. Their handlers stand again as before when
// this is destroyed. One at a time in a process.
//
//   SignalPipe signals({SIGINT, SIGTERM});
//   executor.watch_readable(signals.file(), [&] { for (int signal : signals.take()) ...; });

#include <csignal>
#include <map>
#include <vector>

namespace pizarra::repl {

class SignalPipe {
 public:
  explicit SignalPipe(const std::vector<int>& signals);
  ~SignalPipe();
  SignalPipe(const SignalPipe&) = delete;
  SignalPipe& operator=(const SignalPipe&) = delete;

  int file() const { return read_end_; }
  // The signals that came since the last time, in order.
  std::vector<int> take();

 private:
  int read_end_ = -1;
  std::map<int, struct sigaction> before_;
};

}  // namespace pizarra::repl
