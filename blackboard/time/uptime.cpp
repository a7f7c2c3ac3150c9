#include "blackboard/time/uptime.hpp"

#include <cerrno>
#include <ctime>
#include <system_error>

namespace pizarra {

Duration uptime() {
  timespec since{};
  if (clock_gettime(CLOCK_BOOTTIME, &since) != 0) {
    throw std::system_error(errno, std::generic_category(), "clock_gettime");
  }
  return std::chrono::duration_cast<Duration>(std::chrono::seconds(since.tv_sec) +
                                              std::chrono::nanoseconds(since.tv_nsec));
}

}  // namespace pizarra
