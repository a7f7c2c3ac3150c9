#pragma once

// The making of indexes: what it takes of whoever's request it is made for, and whether any may be made. What an index
// serves comes later, so that it counts for no search's bound.
//
//   Indexing indexing(Indexing::May::make);
//   store.ask(query, examined);
//   examined + indexing.examined();          // as many facts could have been looked at meanwhile
//
// The innermost on this thread counts. Where there is none, every index may be made.

#include <cstddef>
#include <cstdint>

namespace pizarra {

class Indexing {
 public:
  enum class May : std::uint8_t { not_make, make };

  explicit Indexing(May may) : may_(may) { innermost = this; }
  Indexing(const Indexing&) = delete;
  Indexing& operator=(const Indexing&) = delete;
  ~Indexing() { innermost = outer_; }

  std::size_t examined() const { return examined_; }

  static bool may_make() { return innermost == nullptr || innermost->may_ != May::not_make; }
  static void made(std::size_t facts) {
    constexpr std::size_t looks_a_fact = 16;
    if (innermost != nullptr) innermost->examined_ += looks_a_fact * facts;
  }

 private:
  static inline thread_local Indexing* innermost = nullptr;
  Indexing* const outer_ = innermost;
  const May may_;
  std::size_t examined_ = 0;
};

}  // namespace pizarra
