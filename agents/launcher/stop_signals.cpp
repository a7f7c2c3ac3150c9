#include "agents/launcher/stop_signals.hpp"

#include <cassert>
#include <csignal>
#include <sys/signalfd.h>
#include <unistd.h>

namespace pizarra {

StopSignals::StopSignals(Executor& executor) : executor_(executor) {
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, SIGINT);
  sigaddset(&set, SIGTERM);
  sigprocmask(SIG_BLOCK, &set, nullptr);
  file_ = signalfd(-1, &set, SFD_NONBLOCK | SFD_CLOEXEC);
  assert(file_ >= 0);
  executor_.watch_readable(file_, [this] {
    signalfd_siginfo info;
    while (read(file_, &info, sizeof info) == sizeof info) received_ = true;
    executor_.stop();
  });
}

StopSignals::~StopSignals() {
  executor_.unwatch_readable(file_);
  close(file_);
}

}  // namespace pizarra
