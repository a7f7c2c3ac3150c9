#pragma once

// How many elements of lists this thread has compared, hashed, matched or searched for variables, and 64 bytes of long
// text as one: it only grows. A bound on comparisons looks at how much it has grown.
//
//   const std::size_t before = elements_looked_at;
//   ...
//   if (elements_looked_at - before > bound) ...

#include <cstddef>

namespace pizarra {

inline thread_local std::size_t elements_looked_at = 0;

inline void look_at_text(std::size_t bytes) {
  constexpr std::size_t bytes_an_element = 64;
  elements_looked_at += bytes / bytes_an_element;
}

// Elements looked at while it lives are not counted.
class UncountedEffort {
 public:
  UncountedEffort() = default;
  UncountedEffort(const UncountedEffort&) = delete;
  UncountedEffort& operator=(const UncountedEffort&) = delete;
  ~UncountedEffort() { elements_looked_at = before_; }

 private:
  const std::size_t before_ = elements_looked_at;
};

}  // namespace pizarra
