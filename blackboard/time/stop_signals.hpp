#pragma once

// Ends a program in order at SIGINT, SIGTERM, a closed terminal, or an output that nobody reads any more. Given an
// executor, they stop it on its own thread, and run_until() returns. A virtual executor watches no files: there the
// caller of run_until() asks received() between the callbacks.
//
//   RealExecutor executor;
//   const StopSignals signals(executor);      // before any thread is started
//
//   StopSignals signals;
//   executor.run_until([&] { return job.done() || signals.received(); });

#include "blackboard/time/executor.hpp"

namespace pizarra {

class StopSignals {
 public:
  StopSignals();
  explicit StopSignals(Executor& executor);
  ~StopSignals();
  StopSignals(const StopSignals&) = delete;
  StopSignals& operator=(const StopSignals&) = delete;
  // Whether one has come since this was made.
  bool received() const;

 private:
  Executor* executor_ = nullptr;
  int file_;
  mutable bool received_ = false;
};

}  // namespace pizarra
