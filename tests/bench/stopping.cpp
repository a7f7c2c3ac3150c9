#include "tests/bench/stopping.hpp"

#include <csignal>

#include "blackboard/time/executor.hpp"

namespace pizarra::bench {

namespace {

constexpr Duration looks_every = 50ms;
volatile std::sig_atomic_t received = 0;

}  // namespace

void stop_in_order() {
  for (const int stopping : {SIGINT, SIGTERM}) {
    std::signal(stopping, [](int signal) { received = signal; });
  }
}

int stopped_by() { return received; }

void throw_if_stopped() {
  if (stopped_by() != 0) throw Stopped();
}

void throw_when_stopped(Executor& executor) {
  throw_if_stopped();
  executor.call_at(executor.now() + looks_every, [&executor] { throw_when_stopped(executor); });
}

}  // namespace pizarra::bench
