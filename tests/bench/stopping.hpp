#pragma once

// SIGINT and SIGTERM in a bench that makes what outlives a process, as network namespaces: they do not end it at once,
// but have it throw, so that all of that goes with its objects. bench_main.hpp turns the exception into the status.
//
//   stop_in_order();                       // from then on
//   throw_when_stopped(executor);          // out of whatever the executor runs
//   while (...) throw_if_stopped();        // in a loop that waits without it

#include <stdexcept>

namespace pizarra {
class Executor;
}

namespace pizarra::bench {

struct Stopped : std::runtime_error {
  Stopped() : std::runtime_error("stopped by a signal, without a verdict") {}
};

void stop_in_order();
// The signal; 0: none came.
int stopped_by();
void throw_if_stopped();
void throw_when_stopped(Executor& executor);

}  // namespace pizarra::bench
