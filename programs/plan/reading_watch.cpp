#include "programs/plan/reading_watch.hpp"

#include <cstdio>
#include <unistd.h>

namespace pizarra::programs {

namespace {

constexpr std::chrono::milliseconds between_looks{20};

}  // namespace

ReadingWatch::ReadingWatch(PlanClock& clock, std::function<int()> report)
    : thread_([this, &clock, report = std::move(report)](const std::stop_token& read) { watch(read, clock, report); }) {
}

void ReadingWatch::watch(const std::stop_token& read, PlanClock& clock, const std::function<int()>& report) {
  std::unique_lock lock(mutex_);
  while (!read.stop_requested() && !clock.over()) wake_.wait_for(lock, read, between_looks, [] { return false; });
  if (read.stop_requested()) return;
  clock.hide();
  const int status = report();
  std::fflush(stdout);
  // Nothing is taken down that the reading thread may be using.
  _exit(status);
}

}  // namespace pizarra::programs
