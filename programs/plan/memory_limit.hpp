#pragma once

// For as long as it lives, this process cannot take more memory than it had and so many bytes: what asks for more gets
// std::bad_alloc. Behind the engines' own accounts, which are estimates.
//
//   const MemoryLimit limit(std::size_t{2048} << 20);
//   try { plan(); } catch (const std::bad_alloc&) { ... }

#include <cstddef>
#include <sys/resource.h>

namespace pizarra::programs {

class MemoryLimit {
 public:
  explicit MemoryLimit(std::size_t bytes);
  ~MemoryLimit();
  MemoryLimit(const MemoryLimit&) = delete;
  MemoryLimit& operator=(const MemoryLimit&) = delete;

 private:
  rlimit before_{RLIM_INFINITY, RLIM_INFINITY};
};

}  // namespace pizarra::programs
