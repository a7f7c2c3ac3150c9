#pragma once

// Whether another goal, or none, is wanted than the one that is pursued. Whatever is done for it ends then, at its next
// check.
//
//   interruption.raise();                                                  // the goal was replaced or cancelled
//   if (interruption.raised()) co_return interruption.failure();           // interrupted
//   interruption.clear();                                                  // the next goal begins

#include "lisp/result.hpp"

namespace pizarra::coordinator {

class Interruption {
 public:
  void raise() { raised_ = true; }
  void clear() { raised_ = false; }
  bool raised() const { return raised_; }
  std::unexpected<Failure> failure() const { return fail("interrupted", "another goal, or none, is wanted now"); }

 private:
  bool raised_ = false;
};

}  // namespace pizarra::coordinator
