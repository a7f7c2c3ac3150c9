#include "blackboard/time/stop_signals.hpp"

#include <cassert>
#include <csignal>
#include <sys/signalfd.h>
#include <unistd.h>

namespace pizarra {

StopSignals::StopSignals() {
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, SIGINT);
  sigaddset(&set, SIGTERM);
  sigaddset(&set, SIGHUP);
  sigaddset(&set, SIGPIPE);
  sigprocmask(SIG_BLOCK, &set, nullptr);
  file_ = signalfd(-1, &set, SFD_NONBLOCK | SFD_CLOEXEC);
  assert(file_ >= 0);
}

StopSignals::StopSignals(Executor& executor) : StopSignals() {
  executor_ = &executor;
  executor.watch_readable(file_, [this] {
    if (received()) executor_->stop();
  });
}

StopSignals::~StopSignals() {
  if (executor_ != nullptr) executor_->unwatch_readable(file_);
  close(file_);
}

bool StopSignals::received() const {
  signalfd_siginfo info;
  while (read(file_, &info, sizeof info) == sizeof info) received_ = true;
  return received_;
}

}  // namespace pizarra
