#pragma once

// SIGINT and SIGTERM as an orderly end: they stop the executor, on its own thread, and run_until() returns.
//
//   RealExecutor executor;
//   const StopSignals signals(executor);      // before any thread is started

#include "blackboard/time/executor.hpp"

namespace pizarra {

class StopSignals {
 public:
  explicit StopSignals(Executor& executor);
  ~StopSignals();
  StopSignals(const StopSignals&) = delete;
  StopSignals& operator=(const StopSignals&) = delete;
  bool received() const { return received_; }

 private:
  Executor& executor_;
  int file_;
  bool received_ = false;
};

}  // namespace pizarra
