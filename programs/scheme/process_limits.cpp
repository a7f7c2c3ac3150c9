#include "programs/scheme/process_limits.hpp"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

namespace pizarra::programs {

namespace {

constexpr rlim_t megabyte = 1 << 20;
// The collector keeps as much again as is in use before it collects, and the program's stack may take as much, too.
constexpr rlim_t room = 4;
constexpr rlim_t slack = 64 * megabyte;
constexpr rlim_t most_files = 64;
constexpr rlim_t largest_file = 64 * megabyte;  // its log

rlim_t address_space() {
  std::ifstream in("/proc/self/statm");
  rlim_t pages = 0;
  in >> pages;
  return pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE));
}

}  // namespace

Result<void> limit_process(int memory_mb) {
  const rlim_t memory = address_space() + slack + room * megabyte * static_cast<rlim_t>(memory_mb);
  const struct {
    __rlimit_resource what;
    rlim_t most;
  } limits[] = {{RLIMIT_AS, memory},
                {RLIMIT_NOFILE, most_files},
                {RLIMIT_FSIZE, largest_file},
                {RLIMIT_NPROC, 0},
                {RLIMIT_CORE, 0}};
  for (const auto& [what, most] : limits) {
    const rlimit limit{most, most};
    if (setrlimit(what, &limit) != 0) {
      return fail("no-limits", std::string("the process cannot be limited: ") + std::strerror(errno));
    }
  }
  // Nothing that it might start has more rights than it.
  prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
  return {};
}

}  // namespace pizarra::programs
