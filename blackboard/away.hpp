#pragma once

// Whether a request failed because no board was there to do it: it did not answer, or none of several boards knew that
// it leads. Who asks again may be answered.
//
//   if (told || !is_away(told.error())) co_return told;

#include "lisp/result.hpp"

namespace pizarra {

inline bool is_away(const Failure& failure) {
  return failure.symbol == "unreachable" || failure.symbol == "unavailable";
}

}  // namespace pizarra
