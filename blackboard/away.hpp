#pragma once

// Whether a request failed because no board was there to do it: none answered, or none of several boards knew that it
// leads. The same request may succeed later.
//
//   if (told || !is_away(told.error())) co_return told;

#include "lisp/result.hpp"

namespace pizarra {

inline bool is_away(const Failure& failure) {
  return failure.symbol == "unreachable" || failure.symbol == "unavailable";
}

}  // namespace pizarra
