#include "programs/plan/memory_limit.hpp"

#include <algorithm>
#include <fstream>
#include <string>

namespace pizarra::programs {

namespace {

// What the limit counts: private memory that can be written. 0 where the system does not tell.
std::size_t data_bytes() {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    std::size_t kilobytes = 0;
    if (word == "VmData:" && status >> kilobytes) return kilobytes << 10;
  }
  return 0;
}

}  // namespace

MemoryLimit::MemoryLimit(std::size_t bytes) {
  const std::size_t now = data_bytes();
  if (now == 0 || getrlimit(RLIMIT_DATA, &before_) != 0) return;
  const rlimit limited{std::min<rlim_t>(before_.rlim_max, now + bytes), before_.rlim_max};
  setrlimit(RLIMIT_DATA, &limited);
}

MemoryLimit::~MemoryLimit() { setrlimit(RLIMIT_DATA, &before_); }

}  // namespace pizarra::programs
