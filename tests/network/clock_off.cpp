// A library to be loaded before a program, which then sees a wall clock that is off. By how many seconds stands in the
// file that the environment's CLOCK_OFF_FILE names: a long, which may change at any time. Timers and the steady clock
// stay as they are.
//
// It asks the kernel itself and takes no memory: a program's own allocator may ask for the time before anything is
// ready, which Debian's libfaketime does not survive.

#include <cstdlib>
#include <ctime>
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <sys/time.h>
#include <unistd.h>

namespace {

const volatile long* file() {
  const char* const path = std::getenv("CLOCK_OFF_FILE");
  const int opened = path == nullptr ? -1 : open(path, O_RDONLY | O_CLOEXEC);
  if (opened < 0) return nullptr;
  void* const seen = mmap(nullptr, sizeof(long), PROT_READ, MAP_SHARED, opened, 0);
  close(opened);
  return seen == MAP_FAILED ? nullptr : static_cast<const volatile long*>(seen);
}

long offset() {
  static const volatile long* const seconds = file();
  return seconds == nullptr ? 0 : *seconds;
}

}  // namespace

extern "C" {

int clock_gettime(clockid_t clock, timespec* now) noexcept {
  const long result = syscall(SYS_clock_gettime, clock, now);
  if (result == 0 && (clock == CLOCK_REALTIME || clock == CLOCK_REALTIME_COARSE)) now->tv_sec += offset();
  return static_cast<int>(result);
}

int gettimeofday(timeval* __restrict now, void* __restrict) noexcept {
  timespec precise{};
  clock_gettime(CLOCK_REALTIME, &precise);
  now->tv_sec = precise.tv_sec;
  now->tv_usec = precise.tv_nsec / 1000;
  return 0;
}

time_t time(time_t* now) noexcept {
  timespec precise{};
  clock_gettime(CLOCK_REALTIME, &precise);
  if (now != nullptr) *now = precise.tv_sec;
  return precise.tv_sec;
}
}
